import { expect } from '@playwright/test';
import { kernelById, menuName } from '../src/skinning/registry.ts';
import {
  choose,
  controlRow,
  drop,
  expectFittingCanvas,
  getPose,
  openApp,
  setPose,
  vertices,
} from './support/app.ts';
import { cameraOf } from './support/controls.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, sharedPage, test } from './support/test.ts';

// Every edit is one step of undo, and the button shows its name.
test.use({ ...coarse, viewport: { width: 960, height: 440 } });
const page = sharedPage(openApp);

const undo = () => page().getByRole('button', { name: 'Undo' });
const redo = () => page().getByRole('button', { name: 'Redo' });
const open = (id: string) => page().evaluate((id) => window.sinew.open(id), id);
const name = () => page().evaluate(() => window.sinew.characters[0]!.name);

test('undo and redo restore characters that were opened, bundled or dropped', async () => {
  await expect(undo()).toBeDisabled();
  await expect(redo()).toBeDisabled();
  const pose = await setPose(page(), { joints: { Head: [0.25, 0.5, 0] } });
  const shape = await vertices(page(), 'gpu');
  await open('tube');
  await drop(page(), madeCharacter(5, 2));
  expect(await name()).toBe('made');
  await expect(undo()).toHaveAttribute('title', /Open made/);
  await undo().click();
  expect(await name()).toBe('tube');
  await undo().click();
  expect(await name()).toBe('human');
  expect(await getPose(page())).toEqual(pose);
  expect(await vertices(page(), 'gpu')).toEqual(shape);
  await redo().click();
  await redo().click();
  expect(await name()).toBe('made');
  await expect(redo()).toBeDisabled();
  await undo().click();
  await undo().click();
});

test('undoing an opening with a joint selected clears the selection', async () => {
  const treeItem = page().locator('[role=treeitem][aria-selected=true]');
  await open('tube');
  await open('human');
  await page().getByRole('treeitem', { name: 'Head', exact: true }).click();
  await expect(treeItem).toHaveCount(1);
  await undo().click();
  expect(await name()).toBe('tube');
  await expect(treeItem).toHaveCount(0);
  await undo().click();
  expect(await name()).toBe('human');
});

test('undoing an opening frames the character that comes back', async () => {
  await open('hand');
  const opened = await cameraOf(page());
  await undo().click();
  await expectFittingCanvas(page());
  const undone = await cameraOf(page());
  expect(undone.distance).not.toBe(opened.distance);
  await page().locator('canvas.scene').focus();
  await page().keyboard.press('Home');
  expect(await cameraOf(page())).toEqual(undone);
});

test('undo and redo restore poses that were set, reset in part or as a whole', async () => {
  const first = await setPose(page(), { joints: { Head: [0.1, 0, 0], Chest: [0, 0.2, 0] } });
  await controlRow(page(), 'Reset all').locator('button').click();
  expect(await getPose(page())).toEqual({ joints: {} });
  await expect(undo()).toHaveAttribute('title', /Reset the pose/);
  await undo().click();
  expect(await getPose(page())).toEqual(first);
  await setPose(page(), { joints: { Head: [0.3, 0, 0] } });
  await expect(redo(), 'an edit forgets what was undone').toBeDisabled();
});

test('undo and redo restore the method and the use of weights', async () => {
  const shape = await vertices(page(), 'gpu');
  await choose(page(), 'Method', menuName(kernelById('rigid')));
  await expect(page().locator('.status')).toContainText(kernelById('rigid').label);
  expect(await vertices(page(), 'gpu')).not.toEqual(shape);
  await controlRow(page(), 'Normalize weights').getByRole('checkbox').check();
  await undo().click();
  await expect(controlRow(page(), 'Normalize weights').getByRole('checkbox')).not.toBeChecked();
  await undo().click();
  await expect(page().locator('.status')).not.toContainText(kernelById('rigid').label);
  expect(await vertices(page(), 'gpu')).toEqual(shape);
});

test('camera and what is drawn are not undone, but the look of a character is', async () => {
  const title = await undo().getAttribute('title');
  await page().locator('canvas.scene').focus();
  for (const key of ['ArrowLeft', 'a', 'a']) await page().keyboard.press(key);
  expect(await undo().getAttribute('title')).toBe(title);
  await choose(page(), 'Shading', 'Faceted');
  await expect(undo()).toHaveAttribute('title', /Shade in facets/);
  await undo().click();
  await expect(controlRow(page(), 'Shading').locator('option:checked')).toHaveText('Smooth');
});
