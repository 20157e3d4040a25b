import { expect, type Page } from '@playwright/test';
import { controlRow, expectFittingCanvas, openApp } from './support/app.ts';
import { find, type Place } from './support/find-limb.ts';
import { coarse, sharedPage, test } from './support/test.ts';

// A whole character is moved, turned and scaled: by handles in the view, by keys and by numbers.
test.use({ ...coarse, viewport: { width: 900, height: 520 } });
const page = sharedPage((page) => openApp(page, 'model=human'));

const undo = () => page().getByRole('button', { name: 'Undo' });
const text = () => page().locator('.active-dof');
const canvas = () => page().locator('canvas.scene');
const names = () => page().evaluate(() => window.sinew.characters.map(({ name }) => name));
const rows = ['Move X', 'Move Y', 'Move Z', 'Turn X', 'Turn Y', 'Turn Z', 'Size'] as const;
type Row = (typeof rows)[number];

/** The numbers of the place, with three decimals. */
async function placeOf(on: Page): Promise<Record<Row, number>> {
  const values = await Promise.all(
    rows.map((row) =>
      on.locator(`[role=slider][aria-label="Place ${row}"]`).getAttribute('aria-valuenow'),
    ),
  );
  return Object.fromEntries(rows.map((row, i) => [row, Number(values[i])])) as Record<Row, number>;
}

async function setNumber(row: Row, value: string): Promise<void> {
  const field = page().locator(`input[aria-label="Place ${row}"]`);
  await field.fill(value);
  await field.press('Enter');
}

/** Finds a handle below the feet, where no limb is. */
async function handleBeside(on: Page): Promise<Place> {
  const { x, y, width, height } = (await on.locator('canvas.scene').boundingBox())!;
  const middle = x + width / 2;
  const [from, to] = [
    { x: middle - 10, y: y + 0.845 * height },
    { x: middle + 42, y: y + 0.94 * height },
  ];
  return find(on, from, to, 4, { cursor: 'move' });
}

async function drag(from: Place, right: number, down: number): Promise<Place> {
  const to = { x: from.x + right, y: from.y + down };
  const { mouse } = page();
  await mouse.move(from.x, from.y);
  await mouse.down();
  await mouse.move(from.x + right / 2, from.y + down / 2);
  await mouse.move(to.x, to.y);
  return to;
}

test('a handle moves the character along one axis, in steps, finely and back; Esc restores it', async () => {
  const first = await placeOf(page());
  await canvas().focus();
  await page().keyboard.press('w');
  await expect(
    page().getByRole('button', { name: 'Move the character', exact: true }),
  ).toHaveAttribute('aria-pressed', 'true');
  const from = await handleBeside(page());
  const to = await drag(from, 60, 0);
  await expect(text()).toContainText(/^Moved [XYZ] -?0\.\d{3} · Ctrl/);
  const moved = await placeOf(page());
  const changed = rows.filter((row) => moved[row] !== first[row]);
  expect(changed).toHaveLength(1);
  const [row] = changed as [Row];
  expect(await text().textContent()).toContain(
    `${row.slice(-1)} ${(moved[row] - first[row]).toFixed(3)}`,
  );
  await page().mouse.move(from.x, from.y);
  expect(await placeOf(page()), 'the way back').toEqual(first);
  await page().mouse.move(to.x, to.y);
  await page().keyboard.press('Escape');
  expect(await placeOf(page()), 'canceled').toEqual(first);
  await expect(text()).toHaveCount(0);
  await page().mouse.up();
  await expect(undo()).toBeDisabled();

  await page().keyboard.down('Shift');
  await drag(from, 60, 0);
  await page().mouse.up();
  await page().keyboard.up('Shift');
  const fine = await placeOf(page());
  expect(fine[row]).toBeCloseTo(moved[row] / 10, 2);
  await undo().click();
  expect(await placeOf(page()), 'one step of undo').toEqual(first);

  await page().keyboard.down('Control');
  await drag(from, 60, 0);
  await expect(text()).toContainText('in steps of 0.1');
  await page().mouse.up();
  await page().keyboard.up('Control');
  expect((await placeOf(page()))[row]).toBeCloseTo(Math.round(moved[row] * 10) / 10, 9);
  await undo().click();
});

test('its body is a handle on the floor, and its own axes turn with it', async () => {
  const box = (await canvas().boundingBox())!;
  const body = { x: box.x + box.width / 2 - 50, y: box.y + box.height * 0.42 };
  await drag(body, 50, 0);
  await page().mouse.up();
  const moved = await placeOf(page());
  expect(Math.abs(moved['Move X']) + Math.abs(moved['Move Z'])).toBeGreaterThan(0.05);
  expect(moved['Move Y']).toBe(0);
  await undo().click();

  await setNumber('Turn Y', '30°');
  await canvas().focus();
  await page().keyboard.press('q');
  const own = await handleBeside(page());
  await drag(own, 60, 10);
  await expect(text()).toContainText('its own');
  await page().mouse.up();
  const turned = await placeOf(page());
  const slope = Math.atan2(turned['Move Z'], turned['Move X']);
  const along = Math.abs(Math.sin(2 * (slope + Math.PI / 6)));
  expect(along, 'along an axis of the turned character').toBeLessThan(0.02);
  await page().keyboard.press('q');
  await undo().click();
  await undo().click();
});

test('rings turn it and a ring scales it', async () => {
  const first = await placeOf(page());
  await canvas().focus();
  await page().keyboard.press('e');
  await drag(await handleBeside(page()), 0, -40);
  await expect(text()).toContainText(/^Turned [XYZ] -?\d+/);
  await page().mouse.up();
  const turned = await placeOf(page());
  expect(rows.filter((row) => turned[row] !== first[row]).every((row) => /Turn/.test(row))).toBe(
    true,
  );
  expect(turned).not.toEqual(first);
  await undo().click();
  expect(await placeOf(page())).toEqual(first);
  await page().keyboard.press('Shift+E');
  await drag(await handleBeside(page()), 80, 0);
  await page().mouse.up();
  const scaled = await placeOf(page());
  expect(scaled.Size).toBeGreaterThan(1.3);
  expect({ ...scaled, Size: 1 }).toEqual(first);
  await undo().click();
});

test('arrow keys move, turn and scale it by steps, and Esc lays the tool down', async () => {
  await canvas().focus();
  await page().keyboard.press('Escape');
  await page().keyboard.press('w');
  await page().keyboard.down('PageUp');
  await page().keyboard.down('PageUp');
  await page().keyboard.down('PageUp');
  await page().keyboard.up('PageUp');
  expect((await placeOf(page()))['Move Y']).toBe(0.3);
  await undo().click();
  expect((await placeOf(page()))['Move Y'], 'a key that is held is one step').toBe(0);
  await canvas().focus();
  await page().keyboard.press('ArrowRight');
  const moved = await placeOf(page());
  expect(Math.max(Math.abs(moved['Move X']), Math.abs(moved['Move Z']))).toBe(0.1);
  await page().keyboard.press('e');
  await page().keyboard.press('ArrowRight');
  expect((await placeOf(page()))['Turn Y']).toBeCloseTo(Math.PI / 12, 3);
  await page().keyboard.press('Shift+E');
  await page().keyboard.press('ArrowUp');
  expect((await placeOf(page())).Size).toBe(1.1);
  await page().keyboard.press('Escape');
  for (const tool of ['Move', 'Turn', 'Scale']) {
    await expect(
      page().getByRole('button', { name: `${tool} the character`, exact: true }),
    ).toHaveAttribute('aria-pressed', 'false');
  }
  for (let step = 0; step < 3; step++) await undo().click();
  await expect(undo()).toBeDisabled();
});

test('its angles are numbers; it is set on the floor, shown in its own units and put back', async () => {
  const first = await placeOf(page());
  // A tool unfolds the numbers.
  await canvas().focus();
  await page().keyboard.press('w');
  await page().keyboard.press('Escape');
  await setNumber('Turn X', '0.4');
  await setNumber('Turn Y', '2.5');
  await setNumber('Turn Z', '-1');
  await setNumber('Move Y', '2');
  expect(await placeOf(page())).toEqual({
    ...first,
    ...{ 'Turn X': 0.4, 'Turn Y': 2.5, 'Turn Z': -1, 'Move Y': 2 },
  });
  await page().getByRole('button', { name: 'Set on the floor' }).click();
  await expect(page().locator('.status')).toContainText('stands on the floor');
  const set = await placeOf(page());
  expect(set['Move Y']).toBeLessThan(1);
  expect({ ...set, 'Move Y': 2 }).toMatchObject({ 'Turn X': 0.4, 'Turn Y': 2.5, 'Turn Z': -1 });
  const note = page().locator('.note').filter({ hasText: 'units tall in its file' });
  await expect(note).toHaveText('1.7 units tall in its file, 1 here');
  const fit = controlRow(page(), 'Fit to 1 unit').getByRole('checkbox');
  await fit.uncheck();
  await expect(note).toHaveText(/1\.7 units tall in its file, and 1\.7 here, about the file/);
  await page().getByRole('button', { name: 'Reset the place' }).click();
  expect(await placeOf(page())).toEqual(first);
  for (let step = 0; step < 7; step++) await undo().click();
  await expect(fit).toBeChecked();
  expect(await placeOf(page())).toEqual(first);
});

test('a character gets another name, which stays text wherever it is shown', async () => {
  const field = page().getByRole('textbox', { name: /^Name of/ });
  await canvas().focus();
  await page().keyboard.press('F2');
  await expect(field).toBeFocused();
  await page().keyboard.type('Nobody');
  await page().keyboard.press('Escape');
  expect(await names()).toEqual(['human']);
  await expect(page().locator('.actors .name')).toBeFocused();
  await page().locator('.actors .name').dblclick();
  await field.fill('   ');
  await field.press('Enter');
  expect(await names(), 'an empty name is refused').toEqual(['human']);
  await expect(page().locator('.status')).toContainText('human keeps its own');
  await page().locator('.actors .name').dblclick();
  const hostile = '<img src=x onerror=alert(1)>';
  await field.fill(hostile);
  await field.press('Enter');
  expect(await names()).toEqual([hostile]);
  await expect(page().locator('.subject h2')).toHaveText(hostile);
  await expect(page().locator('img[src=x]')).toHaveCount(0);
  const saved = page().waitForEvent('download');
  await page().getByRole('button', { name: 'Save pose' }).click();
  expect((await saved).suggestedFilename()).toContain('img src=x onerror=alert(1)');
  await canvas().focus();
  await page().keyboard.press('h');
  await expect(page().getByRole('button', { name: `Show ${hostile}` })).toBeVisible();
  await undo().click();
  await undo().click();
  expect(await names()).toEqual(['human']);
});

test('a hundred posed copies share mesh, weights and textures; each adds three buffers', async ({
  browser,
}) => {
  const own = await browser.newPage({ viewport: { width: 400, height: 300 } });
  await own.addInitScript(() => {
    const gl = WebGL2RenderingContext.prototype;
    const counts = { bytes: 0, calls: 0 };
    Object.assign(window, { counts });
    const { bufferData } = gl;
    gl.bufferData = function (this: WebGL2RenderingContext, ...parameters: unknown[]) {
      const [, data] = parameters;
      counts.bytes += typeof data === 'number' ? data : (data as ArrayBufferView).byteLength;
      counts.calls++;
      (bufferData as (...all: unknown[]) => void).apply(this, parameters);
    };
  });
  await own.goto('./?test&model=hand');
  await own.evaluate(() => window.sinew.ready);
  const held = () =>
    own.evaluate(async () => {
      await window.sinew.settled();
      const { counts } = window as unknown as { counts: { bytes: number; calls: number } };
      return { ...counts, objects: window.sinew.liveObjects };
    });
  const pose = () =>
    own.evaluate(() => {
      for (const { id } of window.sinew.characters) {
        window.sinew.pose({ joints: { '#2': [0.01 * id, 0.2, 0] } }, id);
      }
    });
  const one = await held();
  await own.evaluate(async () => {
    for (let count = 1; count < 100; count++) await window.sinew.add('hand');
  });
  await pose();
  const all = await held();
  const more = (kind: string): number => all.objects[kind]! - one.objects[kind]!;
  expect(more('buffer')).toBe(3 * 99);
  expect(more('texture')).toBe(0);
  expect(more('program')).toBe(0);
  // Posed positions and normals of every render vertex, and the palette's block.
  const each = (all.bytes - one.bytes) / 99;
  const vertices = await own.evaluate(() => window.sinew.characters[0]!.vertexCount);
  expect(each).toBeGreaterThan(24 * vertices);
  expect(each, 'seams split few vertices').toBeLessThan(1.2 * 24 * vertices + 16 * 1024);
  await pose();
  await own.locator('canvas.scene').press('ArrowLeft');
  const later = await held();
  expect(later, 'a frame makes nothing').toEqual(all);
  await own.close();
});

test.describe('by touch', () => {
  test.use({ ...coarse, viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('one finger moves the character over the floor', async ({ page }) => {
    await openApp(page, 'model=human');
    await expectFittingCanvas(page);
    await page.getByRole('button', { name: 'Move the character', exact: true }).tap();
    const { x, y, width, height } = (await page.locator('canvas.scene').boundingBox())!;
    const client = await page.context().newCDPSession(page);
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', right = 0) =>
      client.send('Input.dispatchTouchEvent', {
        type,
        touchPoints:
          type === 'touchEnd'
            ? []
            : [{ x: x + width / 2 - 45 + right, y: y + height * 0.45, id: 0 }],
      });
    await touch('touchStart');
    for (const right of [15, 30, 45]) await touch('touchMove', right);
    await expect(page.locator('.active-dof')).toHaveText(/^Moved X/);
    await touch('touchEnd');
    const place = await placeOf(page);
    expect(Math.hypot(place['Move X'], place['Move Z'])).toBeGreaterThan(0.02);
    expect(place['Move Y']).toBe(0);
    await page.getByRole('button', { name: 'Undo' }).tap();
    // The browser makes a click of a tap later.
    await expect.poll(async () => (await placeOf(page))['Move X']).toBe(0);
  });
});
