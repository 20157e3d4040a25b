import { expect } from '@playwright/test';
import { getPose, openApp, openJoint, setPose } from './support/app.ts';
import { coarse, sharedPage, test } from './support/test.ts';

// These tests cover what rows of numbers do besides being dragged.
test.use({ ...coarse, viewport: { width: 960, height: 440 } });
const page = sharedPage(openApp);

test.beforeEach(() => setPose(page(), { joints: { Chest: [0.5, 0.25, -0.25] } }));

async function chest() {
  const { joints = {}, root } = await getPose(page());
  return { joint: joints['Chest'], others: Object.keys(joints).length - 1, root };
}

test('typed values may exceed the slider’s range, and degrees are understood', async () => {
  const { field, slider } = await openJoint(page(), 'Chest', 'Y');
  const expected: [string, number][] = [
    ['4', 4],
    ['-7.5', -7.5],
    ['90°', Math.PI / 2],
    ['-45 deg', -Math.PI / 4],
    ['1e-1', 0.1],
  ];
  for (const [typed, value] of expected) {
    await field.fill(typed);
    await field.press('Enter');
    expect((await chest()).joint, typed).toEqual([0.5, expect.closeTo(value, 12), -0.25]);
    await expect(slider).toHaveAttribute('aria-valuenow', value.toFixed(3));
  }
  // Text that is not a number changes nothing.
  await field.fill('left');
  await field.press('Enter');
  expect((await chest()).joint![1]).toBe(0.1);
  await expect(field).toHaveValue('0.100');
});

test('the arrow keys step by a degree, with Shift by ten', async () => {
  const { field } = await openJoint(page(), 'Chest', 'Z');
  await field.focus();
  for (const key of ['ArrowUp', 'Shift+ArrowUp', 'ArrowDown']) await field.press(key);
  expect((await chest()).joint![2]).toBeCloseTo(-0.25 + Math.PI / 18, 6);
});

test('a focused slider follows the usual keys of a slider', async () => {
  const { slider } = await openJoint(page(), 'Chest', 'Z');
  await slider.focus();
  const step = Math.PI / 180;
  const expected: [string, number][] = [
    ['ArrowRight', -0.25 + step],
    ['ArrowDown', -0.25],
    ['PageUp', -0.25 + 10 * step],
    ['Home', -Math.PI],
    ['End', Math.PI],
  ];
  for (const [key, value] of expected) {
    await slider.press(key);
    expect((await chest()).joint![2], key).toBeCloseTo(value, 6);
  }
});

test('a double click resets one value, on the slider or on its name', async () => {
  const { slider, row } = await openJoint(page(), 'Chest', 'X');
  await row.locator('.lil-name').dblclick();
  expect((await chest()).joint).toEqual([0, 0.25, -0.25]);
  await page().keyboard.press('Control+z');
  expect((await chest()).joint).toEqual([0.5, 0.25, -0.25]);
  await slider.dblclick({ position: { x: 3, y: 5 } });
  expect((await chest()).joint).toEqual([0, 0.25, -0.25]);
  // The first press of the double click drags the slider; both presses are one step of undo.
  await page().keyboard.press('Control+z');
  expect((await chest()).joint).toEqual([0.5, 0.25, -0.25]);
});

test('undo and redo act while a number is being typed', async () => {
  const { field } = await openJoint(page(), 'Chest', 'X');
  await field.fill('1');
  expect((await chest()).joint![0]).toBe(1);
  await field.press('Control+z');
  expect((await chest()).joint![0]).toBe(0.5);
  await expect(field).toHaveValue('0.500');
  await field.press('Control+Shift+z');
  expect((await chest()).joint![0]).toBe(1);
  await field.fill('2');
  await field.press('Enter');
  expect((await chest()).joint![0]).toBe(2);
});

test('the root moves by lengths', async () => {
  const { field } = await openJoint(page(), 'Root', 'Move Y');
  await field.fill('0.125');
  await field.press('Enter');
  expect(await chest()).toMatchObject({ root: [0, 0.125, 0], others: 0 });
});

test('"Reset joint" resets only its joint, in one step', async () => {
  await setPose(page(), { joints: { Chest: [0.5, 0.25, -0.25], Head: [0.1, 0, 0] } });
  const { row } = await openJoint(page(), 'Chest', 'X');
  const folder = row.locator('xpath=..');
  await folder.getByRole('button', { name: 'Reset joint' }).click();
  expect(await getPose(page())).toEqual({ joints: { Head: [0.1, 0, 0] } });
  await page().keyboard.press('Control+z');
  expect((await chest()).joint).toEqual([0.5, 0.25, -0.25]);
});

test('rows show values that scripts set', async () => {
  const { field, slider } = await openJoint(page(), 'Chest', 'X');
  await expect(field).toHaveValue('0.500');
  await expect(slider).toHaveAttribute('aria-valuetext', '28.6°');
  await setPose(page(), {});
  await expect(field).toHaveValue('0.000');
  await expect(slider).toHaveAttribute('aria-valuetext', '0°');
});
