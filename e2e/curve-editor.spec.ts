import { expect } from '@playwright/test';
import { framing } from '../src/ui/timeline/time-axis.ts';
import { framingValues, type Place, type Plot, xOf, yOf } from '../src/ui/curve-editor/plot.ts';
import { drop, openApp, openTab } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { keyboardUser } from './support/keyboard-user.ts';
import { expectPicture } from './support/pictures.ts';
import { drawPlainly, openBundled, sharedPage, test } from './support/test.ts';

test.use({ viewport: { width: 1200, height: 700 } });

const none = 'channel { extrapolate constant constant keys 0 { } }';
/** One ball joint, whose x goes up to 0.6 and down again; nothing else of it moves. */
const anim = `animation { range 0 1 numchannels 6
  ${none} ${none} ${none}
  channel { extrapolate constant constant keys 3 {
    0 0 smooth smooth 0.5 0.6 smooth smooth 1 0 smooth smooth } }
  ${none} ${none} }`;

const page = sharedPage(async (page) => {
  await drawPlainly(page);
  await openBundled(page, 'small');
  await openApp(page, 'model=insect');
  await drop(page, [
    { name: 'arm.skel', content: 'balljoint arm { boxmin -1 -1 -1 boxmax 1 1 1 }' },
    { name: 'arm.anim', content: anim },
  ]);
  await openTab(page, 'animate');
  await timelineOf(page).getByRole('button', { name: 'Curves', exact: true }).click();
  await page.locator('.plot canvas').waitFor();
  // What evaluates clips is loaded when one is first bound.
  await page.evaluate(() => window.sinew.seek(0.5));
  await page.waitForFunction(() => window.sinew.pose().joints?.['arm']?.[0] === 0.6);
});

type SharedPage = ReturnType<typeof page>;
const timelineOf = (of: SharedPage) => of.getByRole('region', { name: 'Timeline' });
const timeline = () => timelineOf(page());
const canvas = () => page().locator('.plot canvas');

/** The joint's x at a time, in radians. */
const xAt = (time: number): Promise<number> =>
  page().evaluate((time) => {
    window.sinew.seek(time);
    return window.sinew.pose().joints?.['arm']?.[0] ?? 0;
  }, time);
const times = Array.from({ length: 21 }, (_, i) => i / 20);
const curve = async (): Promise<number[]> => {
  const values: number[] = [];
  for (const time of times) values.push(await xAt(time));
  return values;
};
const undo = () => page().keyboard.press('Control+z');

/** The plot as it opens: the whole clip, and all values. */
async function plotOf(): Promise<{ readonly plot: Plot; readonly corner: Place }> {
  const { x, y, width, height } = (await canvas().boundingBox())!;
  const plot = { time: framing([0, 1]), values: framingValues([0, 0.6]), width, height };
  return { plot, corner: { x, y } };
}

/** A place on the page, by time and value of the plot. */
async function placeOf(time: number, value: number): Promise<Place> {
  const { plot, corner } = await plotOf();
  return { x: corner.x + xOf(plot, time), y: corner.y + yOf(plot, value) };
}

async function dragFrom(from: Place, to: Place): Promise<void> {
  const { mouse } = page();
  await mouse.move(from.x, from.y);
  await mouse.down();
  await mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2);
  await mouse.move(to.x, to.y);
}

test('a key is dragged in time and value as one step, and Escape takes a drag back', async () => {
  const before = await curve();
  await dragFrom(await placeOf(0.5, 0.6), await placeOf(0.7, 0.4));
  await expect(page().locator('.telling')).toHaveText(/^Move 1 key: \+0\.20 s \(\+6 frames\), -/);
  await page().mouse.up();
  expect(await xAt(0.7)).toBeCloseTo(0.4, 1);
  expect(await xAt(0.5)).toBeLessThan(0.4);
  await undo();
  expect(await curve()).toEqual(before);

  await dragFrom(await placeOf(0.5, 0.6), await placeOf(0.7, 0.4));
  await page().keyboard.press('Escape');
  await page().mouse.up();
  expect(await curve()).toEqual(before);
});

test('a handle turns the slope on both sides, and with Alt on its own', async () => {
  const before = await curve();
  const key = await placeOf(0.5, 0.6);
  await page().mouse.click(key.x, key.y);
  const out = page().getByRole('textbox', { name: 'Tangent out of the keys' });
  const into = page().getByRole('textbox', { name: 'Tangent into the keys' });
  await expect(out).toHaveValue('smooth');
  await page().keyboard.press('Escape');
  const end = { x: key.x + 42, y: key.y };
  await dragFrom(end, { x: end.x, y: end.y + 20 });
  await page().mouse.up();
  const turned = await curve();
  expect(turned[12]).toBeLessThan(before[12]!);
  expect(turned[8]).toBeGreaterThan(before[8]!);
  expect(turned[10]).toBe(before[10]);
  await undo();
  expect(await curve()).toEqual(before);

  await page().keyboard.down('Alt');
  await dragFrom(end, { x: end.x, y: end.y + 20 });
  await page().mouse.up();
  await page().keyboard.up('Alt');
  const broken = await curve();
  expect(broken.slice(0, 10)).toEqual(before.slice(0, 10));
  expect(broken[12]).toBeLessThan(before[12]!);
  await page().mouse.click(key.x, key.y);
  await expect(into).toHaveValue('smooth');
  await expect(out).toHaveValue(/^-\d/);
  await page().keyboard.press('Escape');
  await undo();
});

test('a double click inserts a key that changes nothing, and says which slopes are fixed', async () => {
  const before = await curve();
  const value = before[5]!;
  const { x, y } = await placeOf(0.25, value);
  // A frame is at 0.2333 and at 0.2667.
  await page().mouse.dblclick(x, y);
  await expect(page().locator('output.notice')).toHaveText(
    /^Key inserted at 0\.2\d s; slopes of 3 keys are numbers now$/,
  );
  const after = await curve();
  after.forEach((each, i) => expect(Math.abs(each - before[i]!)).toBeLessThan(1e-9));
  await undo();
  expect(await curve()).toEqual(before);
});

test('a clicked key takes typed numbers, in degrees too, and several are changed at once', async () => {
  const before = await curve();
  const { x, y } = await placeOf(0.5, 0.6);
  await page().mouse.click(x, y);
  const value = page().getByRole('textbox', { name: 'Value of the keys' });
  await expect(value).toHaveValue('0.6');
  await value.fill('540°');
  await value.press('Enter');
  expect(await xAt(0.5)).toBeCloseTo(3 * Math.PI, 12);
  await undo();
  await page().keyboard.press('Escape');
  await page().locator('.plot').focus();
  await page().keyboard.press('Control+a');
  await page().keyboard.press('4');
  await expect(page().locator('output.notice')).toHaveText(/3 keys$/);
  expect(await xAt(0.05)).toBeLessThan(before[1]! / 2);
  await undo();
  expect(await curve()).toEqual(before);
});

test('each end goes on by its own rule', async () => {
  const after = page().getByRole('combobox', { name: /^After the keys of/ });
  await timeline().getByRole('button', { name: 'arm X', exact: true }).click();
  // A clip that loops is never shown beyond its end.
  const atEnd = timeline().getByRole('combobox', { name: 'At the end' });
  await atEnd.selectOption('Go on');
  await after.selectOption('cycle');
  expect(await xAt(1.5)).toBeCloseTo(0.6, 12);
  await after.selectOption('cycle with offset');
  await undo();
  await undo();
  await expect(after).toHaveValue('constant');
  expect(await xAt(1.5)).toBe(0);
  await atEnd.selectOption('Loop');
});

test('keys in a rectangle are scaled by their box about its other side', async () => {
  const before = await curve();
  const [a, b] = [await placeOf(0.4, 0.66), await placeOf(1.03, -0.06)];
  await dragFrom(a, b);
  await page().mouse.up();
  // The right side stands 14 pixels beside the key at 1 s, in the middle of the keys' values.
  const side = await placeOf(1, 0.3);
  const to = await placeOf(0.8, 0.3);
  await dragFrom({ x: side.x + 14, y: side.y }, { x: to.x + 14, y: to.y });
  await expect(page().locator('.telling')).toHaveText('Scale 2 keys: 60 % of the time');
  await page().mouse.up();
  expect(await xAt(0.5)).toBeCloseTo(0.6, 12);
  expect(await xAt(0.8)).toBeCloseTo(0, 9);
  await undo();
  expect(await curve()).toEqual(before);
});

test('every key is read and changed in a table by keys alone', async () => {
  const user = keyboardUser(page());
  await timeline().getByRole('combobox', { name: 'Side of the keys' }).focus();
  await user.tabTo('Table');
  await page().keyboard.press('Enter');
  const grid = page().getByRole('grid', { name: 'Keys of arm X' });
  await expect(grid.getByRole('row')).toHaveCount(4);
  const cell = grid.locator('[tabindex="0"]');
  await cell.focus();
  await page().keyboard.press('ArrowDown');
  await page().keyboard.press('ArrowRight');
  await page().keyboard.press('ArrowRight');
  await expect(cell).toBeFocused();
  await expect(cell).toHaveText('0.6 34.4°');
  await page().keyboard.press('Enter');
  await expect(grid.getByRole('textbox')).toBeFocused();
  await page().keyboard.type('0.9');
  await page().keyboard.press('Enter');
  await expect(cell).toBeFocused();
  await page().keyboard.press('ArrowRight');
  await page().keyboard.press('Enter');
  await expect(grid.getByRole('textbox')).toBeFocused();
  await page().keyboard.type('no slope');
  await page().keyboard.press('Enter');
  await expect(grid.getByRole('textbox')).toHaveAttribute('aria-invalid', 'true');
  await page().keyboard.press('ControlOrMeta+a');
  await page().keyboard.type('flat');
  await page().keyboard.press('Enter');
  await expect(cell).toHaveText('flat');
  expect(await xAt(0.5)).toBe(0.9);
  await page().keyboard.press('Space');
  await expect(grid.getByRole('row', { selected: true })).toHaveCount(1);
  expect(await violations(page(), { within: '.curve-editor' })).toEqual([]);
  await undo();
  await undo();
  await timeline().getByRole('button', { name: 'Table', exact: true }).click();
});

test('the plot is as expected, in light and dark colors that a checker accepts', async () => {
  // Whatever came before, all keys fill the plot and the list shows the row of the curve.
  await page().locator('.plot').focus();
  await page().keyboard.press('Control+a');
  await timeline()
    .getByRole('button', { name: 'Frame the selected keys, or all', exact: true })
    .click();
  await timeline()
    .getByRole('button', { name: 'arm X', exact: true })
    .evaluate((row) => row.scrollIntoView({ block: 'end' }));
  const { x, y } = await placeOf(0.5, 0.6);
  await page().mouse.click(x, y);
  await page().mouse.move(5, 5);
  await xAt(0.25);
  await page().evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
  expectPicture('curve-editor', await timeline().screenshot());
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), { within: '.curve-editor', ...onlyColors })).toEqual([]);
  await page().evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
  expectPicture('curve-editor-dark', await timeline().screenshot());
});
