import { expect, type Locator } from '@playwright/test';
import { getPose, openApp, openTab } from './support/app.ts';
import { violations } from './support/axe.ts';
import { expectPicture } from './support/pictures.ts';
import { drawPlainly, openBundled, sharedPage, test } from './support/test.ts';

test.use({ viewport: { width: 960, height: 560 } });
const page = sharedPage(async (page) => {
  await drawPlainly(page);
  await openBundled(page, 'small');
  await openApp(page, 'model=insect');
  await openTab(page, 'animate');
  await expect(page.locator('.dope canvas')).toBeVisible();
});

/** What the timeline frames of the insect's clip, in seconds: 4 s with a little room. */
const shown = [-0.16, 4.16] as const;

const timeline = (): Locator => page().getByRole('region', { name: 'Timeline' });
const names = (): Locator => timeline().getByRole('treegrid', { name: 'Rows of keys' });
const row = (name: string): Locator =>
  names()
    .getByRole('row')
    .filter({ has: page().locator('.text', { hasText: new RegExp(`^${name}$`) }) })
    .last();
const said = (): Locator => timeline().locator('.dope [role=status]');
const undoLabel = (): Locator => page().locator('.top [data-command=undo]');

/** Where the key of a row at a time is on the page. */
async function placeOf(name: string, time: number): Promise<readonly [number, number]> {
  const keys = (await timeline().locator('.dope canvas').boundingBox())!;
  const { y, height } = (await row(name).boundingBox())!;
  const part = (time - shown[0]) / (shown[1] - shown[0]);
  return [keys.x + part * keys.width, y + height / 2];
}

async function drag(
  from: readonly [number, number],
  to: readonly [number, number],
  { release = true } = {},
): Promise<void> {
  await page().mouse.move(...from);
  await page().mouse.down();
  await page().mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
  await page().mouse.move(...to);
  if (release) await page().mouse.up();
}

/** Selects the keys of the walk in one row by a box around them. */
async function boxSelect(name: string): Promise<void> {
  const [left, top] = await placeOf(name, -0.1);
  const [right] = await placeOf(name, 1);
  await drag([left, top - 6], [right, top + 6]);
}

/** The texts of a row's keys, read with the arrow keys. */
async function readKeys(name: string, count: number): Promise<readonly string[]> {
  await row(name).focus();
  await page().keyboard.press('Home');
  const texts: string[] = [];
  for (let at = 0; at < count; at++) {
    await page().keyboard.press('ArrowRight');
    texts.push((await said().textContent())!);
  }
  return texts;
}

const timesOf = (texts: readonly string[]): readonly number[] =>
  texts.map((text) => Number(/([\d.]+) s/.exec(text)![1]));

test('a picture of the rows, and what a checker finds in them', async () => {
  expectPicture('timeline', await timeline().screenshot());
  expect(await violations(page(), { within: '.timeline' })).toEqual([]);
});

test('keys read every key of a row, with its place, its time and its value', async () => {
  await row('abdomen3').focus();
  await page().keyboard.press('ArrowRight');
  await expect(said()).toHaveText('abdomen3, key 1 of 1, 0.00 s, 3 values');
  await page().keyboard.press('Shift+ArrowRight');
  await page().keyboard.press('ArrowDown');
  await page().keyboard.press('ArrowRight');
  await expect(said()).toHaveText(/^abdomen3 X, key 1 of 1, 0\.00 s, -?[\d.]+°$/);
  await page().keyboard.press('ArrowUp');
  await page().keyboard.press('Shift+ArrowLeft');
  const texts = await readKeys('abdomen2', 3);
  expect(texts[2]).toMatch(/^abdomen2, key 3 of 17, /);
});

test('a drag moves a key by whole frames, as one step; Escape takes it back', async () => {
  const [from, to] = [await placeOf('abdomen3', 0), await placeOf('abdomen3', 2.01)];
  await drag(from, to, { release: false });
  await page().keyboard.press('Escape');
  await page().mouse.up();
  expect(timesOf(await readKeys('abdomen3', 1))).toEqual([0]);
  await drag(from, to);
  expect(timesOf(await readKeys('abdomen3', 1))).toEqual([2]);
  await expect(undoLabel()).toHaveAttribute('title', /Move keys/);
  await page().keyboard.press('Control+z');
  expect(timesOf(await readKeys('abdomen3', 1))).toEqual([0]);
  await expect(undoLabel()).toBeDisabled();
});

test('a box selects keys, and its ends scale them about the other end', async () => {
  await boxSelect('abdomen2');
  const before = timesOf(await readKeys('abdomen2', 17));
  const end = timeline().getByRole('slider', { name: /^Last selected key/ });
  const { x, y, width, height } = (await end.boundingBox())!;
  const grip = [x + width / 2, y + height / 2] as const;
  const keys = (await timeline().locator('.dope canvas').boundingBox())!;
  const perSecond = keys.width / (shown[1] - shown[0]);
  await drag(grip, [grip[0] + before.at(-1)! * perSecond, grip[1]]);
  const after = timesOf(await readKeys('abdomen2', 17));
  after.forEach((time, at) => expect(time).toBeCloseTo(before[at]! * 2, 1));
  await end.focus();
  await page().keyboard.press('ArrowLeft');
  expect(timesOf(await readKeys('abdomen2', 17)).at(-1)).toBeLessThan(after.at(-1)!);
  await page().keyboard.press('Control+z');
  await page().keyboard.press('Control+z');
  expect(timesOf(await readKeys('abdomen2', 17))).toEqual(before);
});

test('copied keys are pasted at the playhead, reversed too, and removed', async () => {
  const count = row('abdomen2').locator('.row-count');
  await expect(count).toContainText('17 keys');
  // Undo has brought back the selection of the test before.
  await page().keyboard.press('Control+c');
  await expect(page().locator('.notice')).toHaveText(/^Copied/);
  await page().evaluate(() => window.sinew.seek(2));
  await page().keyboard.press('Control+Shift+v');
  await expect(count).toContainText('34 keys');
  const all = timesOf(await readKeys('abdomen2', 34));
  expect(all[17]).toBe(2);
  await expect(undoLabel()).toHaveAttribute('title', /Paste keys reversed/);
  await page().keyboard.press('Delete');
  await expect(count).toContainText('17 keys');
  await page().keyboard.press('Control+z');
  await page().keyboard.press('Control+z');
  await expect(undoLabel()).toBeDisabled();
});

test('rows fold, and a click on a name selects its joint, whose rows come first', async () => {
  const count = await names().getByRole('row').count();
  await row('body').locator('.fold').click();
  await expect(row('body')).toHaveAttribute('aria-expanded', 'false');
  await expect(names().getByRole('row')).toHaveCount(2);
  await row('body').locator('.fold').click();
  await expect(names().getByRole('row')).toHaveCount(count);
  await row('head').click();
  await expect(page().getByRole('treeitem', { selected: true })).toHaveText('▾head');
  await names().evaluate((list) => list.scrollTo({ top: 0 }));
  const texts = await names().locator('.text').allTextContents();
  expect(texts.slice(0, 5)).toEqual(['All', 'head', 'X', 'Y', 'Z']);
});

test('a drag in the ruler shows the pose of every time that it passes', async () => {
  await page().evaluate(() => window.sinew.seek(0));
  const first = await getPose(page());
  const ruler = (await timeline().locator('.ruler').boundingBox())!;
  const y = ruler.y + ruler.height - 4;
  const x = (time: number) => ruler.x + ((time - shown[0]) / (shown[1] - shown[0])) * ruler.width;
  await drag([x(0.1), y], [x(0.407), y], { release: false });
  await expect(timeline().locator('.playhead')).toHaveText('0.40 s');
  expect(await getPose(page())).not.toEqual(first);
  await page().mouse.up();
});

test('the clip and the work range are changed by their ends', async () => {
  await timeline().getByRole('button', { name: 'More' }).click();
  await page().getByRole('menuitem', { name: 'Start the work range' }).click();
  const start = timeline().getByRole('slider', { name: 'Start of the work range' });
  await expect(start).toHaveAttribute('aria-valuetext', '0.40 s');
  await start.focus();
  await page().keyboard.press('ArrowRight');
  await expect(start).toHaveAttribute('aria-valuetext', '0.43 s');
  await timeline().getByRole('button', { name: 'More' }).click();
  await page().getByRole('menuitem', { name: 'Clear the work range' }).click();
  await expect(start).toHaveCount(0);
  const end = timeline().getByRole('slider', { name: 'End of the clip' });
  await end.focus();
  await page().keyboard.press('ArrowLeft');
  await expect(end).toHaveAttribute('aria-valuetext', '3.97 s');
  await page().keyboard.press('Control+z');
  await expect(end).toHaveAttribute('aria-valuetext', '4.00 s');
});

test('the menu of keys sets their tangents', async () => {
  const [x, y] = await placeOf('body', 0);
  await page().mouse.click(x, y, { button: 'right' });
  await page().getByRole('menuitem', { name: 'Stepped' }).click();
  await expect(undoLabel()).toHaveAttribute('title', /stepped/);
  await page().keyboard.press('Control+z');
});

test('the wheel shows more or less time about the pointer, and its height can be changed', async () => {
  const [x, y] = await placeOf('body', 1);
  await page().mouse.move(x, y);
  const labels = timeline().locator('.marks .labeled');
  await expect(labels.first()).toHaveText('0.0');
  await page().mouse.wheel(0, -1200);
  await expect(labels.first()).not.toHaveText('0.0');
  await row('body').focus();
  await page().keyboard.press('Shift+F');
  await expect(labels.first()).toHaveText('0.0');
  const sheet = timeline().locator('.keys-sheet');
  const before = (await sheet.boundingBox())!.height;
  await timeline().getByRole('separator', { name: 'Height of the timeline' }).focus();
  await page().keyboard.press('ArrowUp');
  await expect.poll(async () => (await sheet.boundingBox())!.height).toBe(before + 20);
});
