import { expect } from '@playwright/test';
import { choose, getPose, openApp, setPose, verify } from './support/app.ts';
import { madePmd } from './support/made-pmd.ts';
import { coarse, sharedPage, test } from './support/test.ts';

// A scene can hold several characters, each with its own pose, method and place.
test.use({ ...coarse, viewport: { width: 960, height: 480 } });
const page = sharedPage((page) => openApp(page, 'model=human'));

const undo = () => page().getByRole('button', { name: 'Undo' });
const list = () => page().locator('.actors .name');
const names = () => page().evaluate(() => window.sinew.characters.map(({ name }) => name));
const selected = () =>
  page().evaluate(() => window.sinew.characters.find((each) => each.selected)?.name);

test('characters of three formats stand side by side, and each is posed and undone on its own', async () => {
  await expect(list()).toHaveCount(1);
  await page().evaluate(() => window.sinew.add('insect'));
  await expect.poll(names).toEqual(['human', 'insect']);
  expect(await selected()).toBe('insect');
  const files = madePmd().map(({ name, content }) => ({
    name,
    base64: Buffer.from(content).toString('base64'),
  }));
  await page().evaluate((files) => {
    const made = files.map(({ name, base64 }) => {
      return new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], name);
    });
    return window.sinew.add(made);
  }, files);
  expect(await names()).toHaveLength(3);
  await expect(list()).toHaveCount(3);

  // Each character has its own vertices, which agree with the GPU, and no two characters overlap.
  const places = await page().evaluate(() => window.sinew.characters.map(({ id }) => id));
  for (const id of places) {
    expect(await page().evaluate((id) => window.sinew.verify(id), id)).toMatchObject({
      identical: true,
    });
  }
  await list().nth(0).click();
  expect(await selected()).toBe('human');
  const posed = await setPose(page(), { joints: { Head: [0.3, 0.4, 0] } });
  await choose(page(), 'Method', 'Rigid parts · rigid');
  await list().nth(1).click();
  await expect(page().locator('.status')).not.toContainText('Rigid parts');
  await list().nth(0).click();
  await expect(page().locator('.status')).toContainText('Rigid parts');
  expect(await verify(page())).toMatchObject({ identical: true });
  await undo().click();
  await expect(page().locator('.status')).not.toContainText('Rigid parts');
  expect(await getPose(page())).toEqual(posed);
  await undo().click();
  expect(await getPose(page())).not.toEqual(posed);
});

test('a button or a key removes the selected character, and undo restores it', async () => {
  await list().nth(2).click();
  const before = await names();
  await page().getByRole('button', { name: 'Remove the character' }).click();
  expect(await names()).toEqual(before.slice(0, 2));
  await undo().click();
  expect(await names()).toEqual(before);
  expect(await selected()).toBe(before[2]);
  await page().locator('canvas.scene').focus();
  await page().keyboard.press('Delete');
  expect(await names()).toEqual(before.slice(0, 2));
  await page().keyboard.press('Control+z');
  expect(await names()).toEqual(before);
});

test('a copy has the pose of its original and a place beside all characters', async () => {
  await list().nth(0).click();
  const posed = await setPose(page(), { joints: { Head: [0, 0.7, 0] } });
  await page().locator('canvas.scene').focus();
  await page().keyboard.press('Control+d');
  await expect(list()).toHaveCount(4);
  await expect(list().nth(3)).toHaveText('human 2');
  await expect(list().nth(3)).toHaveAttribute('aria-pressed', 'true');
  expect(await getPose(page())).toEqual(posed);
  const place = page().locator('[role=slider][aria-label="Place Move X"]');
  expect(Number(await place.getAttribute('aria-valuenow'))).toBeGreaterThan(1);
  await undo().click();
  await expect(list()).toHaveCount(3);
});

test('a click on another character selects it and its joint', async () => {
  await list().nth(1).click();
  await page().keyboard.press('Home');
  const box = (await page().locator('canvas.scene').boundingBox())!;
  // The human is at the left of the row, with the insect beside it.
  const hit = async (): Promise<boolean> => {
    for (const y of [0.5, 0.42, 0.58]) {
      for (let x = 0.08; x < 0.5; x += 0.02) {
        await page().mouse.click(box.x + box.width * x, box.y + box.height * y);
        if ((await selected()) === 'human') return true;
      }
    }
    return false;
  };
  expect(await hit()).toBe(true);
  await expect(page().locator('[role=treeitem][aria-selected=true]')).toHaveCount(1);
});

test('twenty copies share mesh, skin and textures', async () => {
  await page().setViewportSize({ width: 760, height: 420 }); // a small view is drawn faster
  await page().evaluate(async () => {
    while (window.sinew.characters.length > 1) window.sinew.remove();
    await window.sinew.open('insect');
    await window.sinew.capture();
  });
  const counts = () => page().evaluate(() => window.sinew.liveObjects);
  const one = await counts();
  await page().evaluate(async () => {
    for (let i = 0; i < 19; i++) await window.sinew.add('insect');
    await window.sinew.capture();
  });
  expect(await page().evaluate(() => window.sinew.characters.length)).toBe(20);
  const twenty = await counts();
  expect(twenty['texture']).toBe(one['texture']);
  // Each copy has its own buffers for posed positions, posed normals and the palette.
  expect(twenty['buffer']).toBeLessThanOrEqual(one['buffer']! + 19 * 3);
  await page().evaluate(async () => {
    for (let i = 0; i < 19; i++) window.sinew.remove();
    await window.sinew.capture();
  });
  await expect.poll(counts).toEqual(one);
});
