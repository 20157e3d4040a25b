import { expect } from '@playwright/test';
import { kernelById } from '../src/skinning/registry.ts';
import {
  choose,
  controlRow,
  drop,
  expectFittingCanvas,
  getPose,
  openApp,
  openJoint,
  setPose,
  vertices,
} from './support/app.ts';
import { cameraOf } from './support/controls.ts';
import { madeCharacter } from './support/made-character.ts';
import { sharedPage, test } from './support/test.ts';

// Every edit is one step of undo, and the button shows its name.
test.use({ viewport: { width: 860, height: 600 } });
const page = sharedPage(openApp);

const undo = () => page().getByRole('button', { name: 'Undo' });
const redo = () => page().getByRole('button', { name: 'Redo' });
const name = () => page().evaluate(() => window.sinew.characters[0]!.name);

test('undo and redo restore characters that were opened, bundled or dropped', async () => {
  await expect(undo()).toBeDisabled();
  await expect(redo()).toBeDisabled();
  const pose = await setPose(page(), { joints: { Head: [0.25, 0.5, 0] } });
  const shape = await vertices(page(), 'gpu');
  await page().getByRole('button', { name: 'Twisting tube' }).click();
  await expect.poll(name).toBe('tube');
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

test('undoing an opening with a joint selected clears the selection, and the picker marks the open character', async () => {
  const picker = (label: string) => page().getByRole('button', { name: label, exact: true });
  const treeItem = page().locator('[role=treeitem][aria-selected=true]');
  await picker('Twisting tube').click();
  await expect.poll(name).toBe('tube');
  await picker('Human').click();
  await expect.poll(name).toBe('human');
  await page().getByRole('treeitem', { name: 'Head', exact: true }).click();
  await expect(treeItem).toHaveCount(1);
  await undo().click();
  expect(await name()).toBe('tube');
  await expect(treeItem).toHaveCount(0);
  await expect(picker('Twisting tube')).toHaveAttribute('aria-pressed', 'true');
  await expect(picker('Human')).toHaveAttribute('aria-pressed', 'false');
  await undo().click();
  expect(await name()).toBe('human');
});

test('choosing your own character again keeps its pose, and its sliders still move it', async () => {
  await drop(page(), madeCharacter(5, 2));
  const own = page().getByRole('button', { name: 'made', exact: true });
  const { joints } = await page().evaluate(() => window.sinew.characters[0]!);
  const posed = await setPose(page(), { joints: { [joints[1]!]: [0.5, 0, 0] } });
  await own.click();
  expect(await getPose(page())).toEqual(posed);
  // Going away and back opens the same character under another id, and its rows act on it.
  await page().getByRole('button', { name: 'Twisting tube' }).click();
  await expect.poll(name).toBe('tube');
  await own.click();
  await expect.poll(name).toBe('made');
  const { field } = await openJoint(page(), joints[1]!, 'X');
  await field.fill('0.25');
  await field.blur();
  expect((await getPose(page())).joints?.[joints[1]!]).toEqual([0.25, 0, 0]);
  for (let i = 0; i < 5; i++) await undo().click();
  expect(await name()).toBe('human');
});

test('undoing an opening frames the character that comes back', async () => {
  await page().getByRole('button', { name: 'Hand', exact: true }).click();
  await expect.poll(name).toBe('hand');
  const opened = await cameraOf(page());
  await undo().click();
  await expectFittingCanvas(page());
  const undone = await cameraOf(page());
  expect(undone.distance).not.toBe(opened.distance);
  await page().locator('canvas').focus();
  await page().keyboard.press('Home');
  expect(await cameraOf(page())).toEqual(undone);
});

test('a click brings back your own characters of earlier drops', async () => {
  const [first, second] = ['first', 'second'].map((stem) =>
    madeCharacter(5, 2).map((file) => ({ ...file, name: file.name.replace('made', stem) })),
  );
  const own = (label: string) => page().getByRole('button', { name: label, exact: true });
  await drop(page(), first!);
  await drop(page(), second!);
  await expect.poll(name).toBe('second');
  await own('first').click();
  await expect.poll(name).toBe('first');
  // Dropping their files again replaces the existing character.
  await drop(page(), first!);
  await expect(own('first')).toHaveCount(1);
  await expect(own('second')).toHaveCount(1);
  for (let i = 0; i < 4; i++) await undo().click();
  await expect.poll(name).toBe('human');
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
  await choose(page(), 'Method', kernelById('rigid').label);
  await expect(page().locator('.status')).toContainText(kernelById('rigid').label);
  expect(await vertices(page(), 'gpu')).not.toEqual(shape);
  await controlRow(page(), 'Normalize weights').getByRole('checkbox').check();
  await undo().click();
  await expect(controlRow(page(), 'Normalize weights').getByRole('checkbox')).not.toBeChecked();
  await undo().click();
  await expect(page().locator('.status')).not.toContainText(kernelById('rigid').label);
  expect(await vertices(page(), 'gpu')).toEqual(shape);
});

test('camera, shading and what is drawn are not undone', async () => {
  const title = await undo().getAttribute('title');
  await page().locator('canvas').focus();
  for (const key of ['ArrowLeft', 'a', 'a']) await page().keyboard.press(key);
  await choose(page(), 'Shading', 'Faceted');
  expect(await undo().getAttribute('title')).toBe(title);
});
