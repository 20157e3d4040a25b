import { expect } from '@playwright/test';
import { capture, getPose, openApp, openJoint, setPose } from './support/app.ts';
import { cameraOf, drawnOf } from './support/controls.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use({ ...coarse, viewport: { width: 960, height: 440 } });
const page = sharedPage(openApp);
const press = (...keys: string[]) =>
  keys.reduce((before, key) => before.then(() => page().keyboard.press(key)), Promise.resolve());

// Every test begins with the focus on the view, the camera of a first visit, and the same pose.
const pose = { joints: { Head: [0.3, 0, 0] as [number, number, number] } };
test.beforeEach(async () => {
  await page().locator('canvas.scene').focus();
  await press('Space');
  await setPose(page(), pose);
});

test('"s" cycles through skin, skeleton and both, and "a" toggles the axes', async () => {
  expect(await drawnOf(page())).toEqual(['Skin']);
  const cycle = [['Skeleton'], ['Skin', 'Skeleton'], ['Skin']];
  for (const drawn of cycle) {
    await press('s');
    expect(await drawnOf(page())).toEqual(drawn);
  }
  await press('a');
  expect(await drawnOf(page())).toEqual(['Skin', 'Axes']);
  await press('A');
  expect(await drawnOf(page())).toEqual(['Skin']);
});

test('"r" resets the pose; Ctrl+Z and Ctrl+Shift+Z undo and redo', async () => {
  await press('r');
  expect(await getPose(page())).toEqual({ joints: {} });
  await press('Control+z');
  expect(await getPose(page())).toEqual(pose);
  await press('Control+Shift+Z');
  expect(await getPose(page())).toEqual({ joints: {} });
  await press('Meta+z');
  expect(await getPose(page())).toEqual(pose);
});

test('arrows orbit, Space resets the camera, and Home frames the character', async () => {
  const before = await cameraOf(page());
  const picture = await capture(page());
  await press('ArrowRight', 'ArrowUp');
  expect(await cameraOf(page())).toEqual({
    azimuth: before.azimuth + 15,
    elevation: before.elevation + 15,
    distance: before.distance,
  });
  await press('ArrowLeft', 'ArrowLeft', 'ArrowDown');
  expect(await cameraOf(page())).toEqual({ ...before, azimuth: before.azimuth - 15 });
  await press('Space');
  expect(await cameraOf(page())).toEqual(before);
  expect(await capture(page())).toEqual(picture);
  // Home keeps the direction, and fits the posed character.
  await setPose(page(), { joints: {}, root: [3, 0, 0] });
  await press('Home');
  expect(await cameraOf(page())).toMatchObject({ azimuth: before.azimuth });
  expect(await capture(page())).not.toEqual(picture);
});

test('"?" shows the keys and what the pointer does, and Escape closes the sheet', async () => {
  const sheet = page().getByRole('dialog');
  await press('?');
  await expect(sheet).toBeVisible();
  for (const text of ['Undo', 'Orbit', 'Save a picture', 'Ctrl/Cmd+Shift+Z', 'Space']) {
    await expect(sheet).toContainText(text);
  }
  await press('r');
  expect(await getPose(page()), 'letters wait while the sheet is open').toEqual(pose);
  await press('Escape');
  await expect(sheet).toBeHidden();
  await page().getByRole('button', { name: 'Show all keys' }).click();
  await expect(sheet).toBeVisible();
  await sheet.getByRole('button', { name: 'Close' }).click();
  await expect(sheet).toBeHidden();
});

test('the sheet that is opened again before the next frame stays open', async () => {
  const sheet = page().getByRole('dialog');
  await press('?');
  await expect(sheet).toBeVisible();
  await page().evaluate(async () => {
    document.querySelector<HTMLButtonElement>('dialog header button')?.click();
    await Promise.resolve();
    dispatchEvent(new KeyboardEvent('keydown', { key: '?', bubbles: true }));
    const frame = () => new Promise(requestAnimationFrame);
    await frame();
    await frame();
  });
  await expect(sheet).toBeVisible();
  await press('Escape');
  await expect(sheet).toBeHidden();
});

test('single-letter keys can be turned off, for users of speech input', async () => {
  const sheet = page().getByRole('dialog');
  const letters = sheet.getByRole('checkbox', { name: 'Single letters act' });
  await press('?');
  await letters.uncheck();
  await sheet.getByRole('button', { name: 'Close' }).click();
  await press('r', 's', 'a');
  expect(await getPose(page())).toEqual(pose);
  expect(await drawnOf(page())).toEqual(['Skin']);
  await page().getByRole('button', { name: 'Show all keys' }).click();
  await letters.check();
  await sheet.getByRole('button', { name: 'Close' }).click();
});

test('letters do not act while a field has the focus, but undo does', async () => {
  const { field } = await openJoint(page(), 'Chest', 'X');
  await field.focus();
  await press('r', 's', 'a', '?');
  expect(await getPose(page())).toEqual(pose);
  expect(await drawnOf(page())).toEqual(['Skin']);
  await expect(page().getByRole('dialog')).toBeHidden();
  await page().getByRole('searchbox', { name: 'Search joints' }).focus();
  await press('r', 's', 'a');
  expect(await getPose(page())).toEqual(pose);
  expect(await drawnOf(page())).toEqual(['Skin']);
  await page().getByRole('searchbox', { name: 'Search joints' }).fill('');
});

test('letters act after a button of the controls was used', async () => {
  await page().locator('.lil-controller').getByRole('button', { name: 'Reset all' }).click();
  expect(await getPose(page())).toEqual({ joints: {} });
  await press('Control+z');
  expect(await getPose(page())).toEqual(pose);
  await press('a');
  expect(await drawnOf(page())).toEqual(['Skin', 'Axes']);
  await press('a', 'r');
  expect(await getPose(page())).toEqual({ joints: {} });
});

test('Escape cancels a slider drag in progress', async () => {
  const { slider } = await openJoint(page(), 'Chest', 'X');
  const { x, y, width, height } = (await slider.boundingBox())!;
  await page().mouse.move(x + width / 2, y + height / 2);
  await page().mouse.down();
  await page().mouse.move(x + width * 0.9, y + height / 2);
  expect((await getPose(page())).joints).toHaveProperty('Chest');
  await press('Escape');
  await page().mouse.move(x + width * 0.8, y + height / 2);
  await page().mouse.up();
  expect(await getPose(page())).toEqual(pose);
});
