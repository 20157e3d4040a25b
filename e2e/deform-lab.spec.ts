import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { PNG } from 'pngjs';
import { capture, choose, getPose, openApp, openTab, setPose, startOver } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { countedUser } from './support/counted-user.ts';
import { courseCharacter } from './support/course-character.ts';
import { find } from './support/find-limb.ts';
import { expectPicture } from './support/pictures.ts';
import { sharedPage, test } from './support/test.ts';

test.use({ viewport: { width: 900, height: 560 } });
const page = sharedPage((page) => openApp(page, 'model=human'));

const canvas = () => page().locator('canvas.scene');
/** A pose that is offered over the view; the Deform tab offers them as well. */
const offered = (name: string) => page().locator('.comparison-foot').getByRole('button', { name });
const mark = () => page().getByRole('button', { name: /^Largest difference of/ });
const wipe = () => page().getByRole('slider', { name: /^Wipe between/ });
const settled = () => page().evaluate(() => window.sinew.settled());
const small = { width: 320, height: 320 };

async function press(key: string): Promise<void> {
  await canvas().focus();
  await page().keyboard.press(key);
}

/** The pixels that the page shows, without what lies over them. */
async function seen(): Promise<PNG> {
  await settled();
  await page().evaluate(() => {
    document.querySelector<HTMLElement>('.overlay')!.style.visibility = 'hidden';
    (document.activeElement as HTMLElement | null)?.blur();
    return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  });
  const bytes = await canvas().screenshot();
  await page().evaluate(() => {
    document.querySelector<HTMLElement>('.overlay')!.style.visibility = '';
  });
  return PNG.sync.read(bytes);
}

/** The view as the page shows it, with what is drawn over the scene. */
async function shown(): Promise<Buffer> {
  return PNG.sync.write(await seen());
}

/** Columns of pixels, which are parts of the width, in one list. */
function columns({ data, width, height }: PNG, from: number, to: number): Buffer {
  const [left, right] = [Math.ceil(from * width) + 3, Math.floor(to * width) - 3];
  return Buffer.concat(
    Array.from({ length: height - 6 }, (_, y) =>
      data.subarray(((y + 3) * width + left) * 4, ((y + 3) * width + right) * 4),
    ),
  );
}

test('x shows where two methods differ most, in a pose that tells it, and gives all back', async () => {
  await setPose(page(), {});
  const [before, plain] = [await getPose(page()), await capture(page(), 'png', small)];
  await press('x');
  await expect(page().locator('.offered')).toContainText('hardly differ');
  await settled();
  expectPicture('lab-at-rest', await capture(page(), 'png', small));
  await offered('Twist the forearm').click();
  await settled();
  await expect(mark()).toHaveText(/^0\.\d+ \([1-9](\.\d+)? %\)$/);
  await expect(page().locator('.offered')).toHaveCount(0);
  await expect(page().locator('.compared')).toHaveText('Linear blend (SSD)Dual quaternions');
  expectPicture('lab-wipe', await capture(page(), 'png', small));
  await mark().click();
  await expect(mark()).toHaveAttribute('aria-pressed', 'true');
  await press('x');
  await expect(mark()).toHaveCount(0);
  expect(await getPose(page())).toEqual(before);
  expect((await capture(page(), 'png', small)).equals(plain), 'the camera is back').toBe(true);
});

test('a click on the mark explains the vertex by both methods, and its weights are edited there', async () => {
  test.setTimeout(60_000);
  await setPose(page(), {});
  await press('x');
  await offered('Twist the forearm').click();
  await mark().click();
  const inspector = page().locator('.vertex-inspector');
  const number = inspector.getByRole('spinbutton', { name: /^Vertex/ });
  const last = (name: string) =>
    inspector.getByRole('region', { name }).getByRole('row', { name: /^Σ/ });
  const place = last('w·T·B⁻¹·p, and their sum: the vertex');
  await expect(place).toHaveText(/^Σ(-?\d\.\d{4}){3}$/);
  await expect(last('That motion of p: the vertex')).toBeVisible();
  expect(await violations(page())).toEqual([]);
  await settled();
  expectPicture('lab-inspector', await shown());
  const [vertex, before] = [await number.inputValue(), await place.textContent()];
  const slider = inspector.getByRole('slider').first();
  await slider.fill('0.9');
  await expect(place).not.toHaveText(before!);
  await inspector.getByRole('button', { name: 'Reset vertex' }).click();
  await expect(place).toHaveText(before!);
  const undo = page().locator('.top [data-command="undo"]');
  await undo.click();
  await expect(place).not.toHaveText(before!);
  await undo.click();
  await expect(place).toHaveText(before!);
  await inspector.getByRole('combobox').selectOption({ index: 1 });
  const joints = inspector.getByRole('button', { name: /^Remove/ });
  const count = await joints.count();
  await joints.last().click();
  await expect(joints).toHaveCount(count - 1);
  const { x, y, width, height } = (await canvas().boundingBox())!;
  await page().mouse.click(x + 0.45 * width, y + 0.45 * height);
  await expect(number).not.toHaveValue(vertex);
  await number.fill('12');
  await expect(number).toHaveValue('12');
  await page().locator('.vertex-inspector > summary').click();
  await expect(number).toHaveCount(0);
  await press('x');
  await startOver(page());
});

test('each part is the picture of its method there, pixel for pixel', async () => {
  await setPose(page(), {});
  await press('x');
  await offered('Bend the elbow').click();
  const bent = await getPose(page());
  // A camera that the user has moved stays where it is at the end; the offered pose does not.
  await press('ArrowRight');
  const at = await wipe().boundingBox();
  await wipe().focus();
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowLeft']) await page().keyboard.press(key);
  expect((await wipe().boundingBox())!.x).toBeGreaterThan(at!.x);
  const place = Number(await wipe().getAttribute('aria-valuenow')) / 100;
  await openTab(page(), 'deform');
  const wiped = await seen();
  await choose(page(), 'Compare with', 'Nothing');
  await setPose(page(), bent);
  const linear = await seen();
  await choose(page(), 'Method', 'Dual quaternions · dqs');
  const dual = await seen();
  const [left, right] = [place - 0.01, place + 0.01];
  expect(columns(linear, 0, 1).equals(columns(dual, 0, 1))).toBe(false);
  expect(columns(wiped, 0, left).equals(columns(linear, 0, left)), 'left').toBe(true);
  expect(columns(wiped, right, 1).equals(columns(dual, right, 1)), 'right').toBe(true);
  await startOver(page());
});

test('in each part the pointer lights limbs, and undo and the camera work', async () => {
  await setPose(page(), {});
  await press('x');
  await offered('Twist the forearm').click();
  const twisted = await getPose(page());
  await openTab(page(), 'deform');
  await page().locator('.deform-lab').getByRole('button', { name: 'Side by side' }).click();
  const { x, y, width, height } = (await canvas().boundingBox())!;
  for (const part of [0, 1]) {
    const middle = { x: x + ((part + 0.5) * width) / 2, y: y + height / 2 };
    const near = 0.12 * width;
    const from = { x: middle.x - near, y: middle.y - near };
    const to = { x: middle.x + near, y: middle.y + near };
    await find(page(), from, to, 16, { limb: 'Right forearm' });
    const seenBefore = await capture(page(), 'png', small);
    await page().mouse.move(middle.x, y + height - 30);
    await page().mouse.down();
    await page().mouse.move(middle.x + 20, y + height - 30, { steps: 2 });
    await page().mouse.up();
    expect((await capture(page(), 'png', small)).equals(seenBefore)).toBe(false);
  }
  await page().locator('.top [data-command="undo"]').click();
  expect(await getPose(page())).not.toEqual(twisted);
  await page().locator('.top [data-command="redo"]').click();
  expect(await getPose(page())).toEqual(twisted);
});

test('the lab has its numbers in colors and in a table that can be read aloud', async () => {
  const lab = page().locator('.deform-lab');
  await lab.getByRole('button', { name: 'Differences in color' }).click();
  await lab.getByRole('button', { name: 'Side by side' }).click();
  await settled();
  await expect(page().getByRole('region', { name: 'Legend of the differences' })).toContainText(
    '%',
  );
  expectPicture('lab-heat', await capture(page(), 'png', small));
  const row = lab.getByRole('row', { name: /^dqs/ });
  await expect(row).toContainText(/0\.0\d+/);
  // Times come when the page was quiet for a moment.
  await expect(row.getByRole('cell').nth(3)).toHaveText(/^\d+\.\d+$/);
  expect(await violations(page())).toEqual([]);
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), onlyColors)).toEqual([]);
  await page().emulateMedia({ colorScheme: 'light' });
  await press('x');
  await startOver(page());
});

test('an engineer compares methods on own file and pose, and saves numbers and picture: 6 presses', async () => {
  const user = countedUser(page());
  const { x, y } = (await canvas().boundingBox())!;
  const files = courseCharacter();
  await user.drop(files, { x: x + 200, y: y + 200 });
  await expect(page().locator('header.subject')).toContainText('course');
  const pose = JSON.stringify(await getPose(page()));
  await user.drop([{ name: 'POSE.json', content: pose }], { x: x + 200, y: y + 200 });
  await settled();
  await user.click(page().getByRole('button', { name: /^Compare skinning methods/ }));
  await expect(page().locator('.compared')).toContainText('Dual quaternions');
  await user.click(page().locator('.top [data-tab="deform"]'));
  for (const [name, file] of [
    ['Save the differences of compared methods as CSV', /comparison\.csv$/],
    ['Save a picture', /\.png$/],
  ] as const) {
    const download = page().waitForEvent('download');
    const command = name === 'Save a picture' ? 'save-picture' : 'save-comparison';
    await user.click(page().locator(`.deform-lab [data-command="${command}"]`));
    expect((await download).suggestedFilename()).toMatch(file);
    if (command === 'save-picture') continue;
    const text = readFileSync(await (await download).path(), 'utf8');
    expect(text.split('\n')[0]).toBe('quantity,vertex,lbs,dqs');
    expect(text).toContain('volume / rest');
  }
  expect(user.presses).toBe(6);
  await press('x');
});
