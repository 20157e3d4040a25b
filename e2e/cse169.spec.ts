import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { leg, legAnim, legSkel } from '../tests/support/cse169-files.ts';
import {
  chooseFromMenu,
  controlRow,
  drop,
  getPose,
  openApp,
  openJoint,
  openTab,
  vertices,
  verify,
} from './support/app.ts';
import { drawnOf } from './support/controls.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use({ ...coarse, viewport: { width: 960, height: 440 } });
const page = sharedPage(async (page) => {
  await openApp(page, 'model=insect&workspace=cse169');
  for (const tab of ['deform', 'animate'] as const) await openTab(page, tab);
});

/**
 * Waits until the insect is open; the status line may still show the notice of an earlier opening.
 */
const insectOf = (): Promise<void> => page().evaluate(() => window.sinew.open('insect'));
const timeline = () => page().getByRole('region', { name: 'Timeline' });
const clipTime = async (): Promise<number> =>
  Number(await timeline().getByRole('slider', { name: 'Time' }).inputValue());

test('the workspace shows boxes, and its normals are the course’s on both the GPU and the CPU', async () => {
  expect(await page().evaluate(() => window.sinew.problems)).toEqual([]);
  expect(await drawnOf(page())).toEqual(['Skeleton']);
  await expect(controlRow(page(), 'Skeleton as').locator('option:checked')).toHaveText('Boxes');
  const chosen = (row: string) => controlRow(page(), row).locator('option:checked');
  await expect(chosen('Method')).toHaveText('Linear blend (SSD) · lbs');
  await expect(chosen('Normals')).toHaveText('per joint (CSE169)');
  await expect(page().locator('.status')).toContainText('Linear blend, CSE169 normals');
  expect(await verify(page())).toMatchObject({ identical: true, bindError: null });
});

test('a click on a box selects its joint, whose number then shows in the picture', async () => {
  const box = (await page().locator('canvas.scene').boundingBox())!;
  await page().mouse.click(box.x + box.width * 0.535, box.y + box.height * 0.472);
  const selected = page().getByRole('treeitem', { selected: true });
  await expect(selected).toHaveText(/\w/);
  const joint = (await selected.textContent())!.replace(/[▸▾]/, '');
  const { field } = await openJoint(page(), joint, 'X');
  await field.fill('0.2');
  await field.press('Enter');
  await expect(page().locator('.active-dof')).toHaveText(`${joint} X 0.200 (11.5°)`);
  await page().keyboard.press('Escape');
  await page().getByRole('button', { name: 'Reset all' }).click();
});

test('a search by words finds degrees of freedom in any joint', async () => {
  const search = page().getByRole('searchbox', { name: 'Search degrees of freedom' });
  await search.fill('leg_l1_femur x');
  const rows = page().locator('.joints .lil-controller:visible .lil-slider');
  await expect(rows).toHaveCount(1);
  await expect(rows).toHaveAttribute('aria-label', 'leg_l1_femur X');
  await search.fill('no such joint');
  await expect(rows).toHaveCount(0);
  await search.fill('');
  await expect(page().locator('.joints .lil-title:visible').first()).toBeVisible();
});

test('stepping from joint to joint shows the degrees of freedom of only that joint', async () => {
  await page().getByRole('treeitem', { name: 'body', exact: true }).click();
  await page().getByRole('button', { name: 'Next joint' }).click();
  await expect(page().locator('.joints .lil-title[aria-expanded="true"]')).toHaveText([
    'All joints',
    'abdomen1',
  ]);
  await page().getByRole('button', { name: 'Previous joint' }).click();
  await expect(page().locator('.joints .lil-title[aria-expanded="true"]')).toHaveText([
    'All joints',
    'body',
  ]);
});

test('a locked angle is shown, can’t be changed, and says why', async () => {
  const { slider, field, row } = await openJoint(page(), 'leg_l1_tibia', 'Y');
  await expect(field).toBeDisabled();
  await expect(slider).toHaveAttribute('aria-disabled', 'true');
  await expect(row).toHaveAttribute('title', 'leg_l1_tibia Y is locked: its limits are equal');
  await expect(slider).toHaveAttribute('aria-description', /is locked: its limits are equal$/);
  // The explanation shows when the pointer rests on the row.
  const box = (await row.boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const under = ([x, y]: number[]) => document.elementFromPoint(x!, y!)?.getAttribute('title');
  expect(await page().evaluate(under, [x, y])).toMatch(/locked/);
});

test('morph sliders end at 1, and typed values may go beyond', async () => {
  const rest = await vertices(page(), 'gpu');
  const field = page().locator('input[aria-label="insect_breathe"]');
  await field.fill('1.5');
  await field.press('Enter');
  expect(await page().evaluate(() => window.sinew.morphs())).toEqual({
    insect_alert: 0,
    insect_breathe: 1.5,
  });
  const swollen = await vertices(page(), 'gpu');
  expect(swollen).not.toEqual(rest);
  expect(await verify(page())).toMatchObject({ identical: true });
  await page().keyboard.press('Control+z');
  expect(await vertices(page(), 'gpu')).toEqual(rest);
});

test('a clip plays, pauses and steps; an edit is held over its pose, which a release keeps', async () => {
  await insectOf();
  await page().locator('canvas.scene').focus();
  await page().keyboard.press('p');
  await expect.poll(clipTime).toBeGreaterThan(0.1);
  await page().keyboard.press('p');
  const paused = await clipTime();
  await page().waitForTimeout(100);
  expect(await clipTime()).toBe(paused);
  const time = timeline().getByRole('slider', { name: 'Time' });
  await time.focus();
  await page().keyboard.press('ArrowRight');
  const end = Number(await time.getAttribute('max'));
  const next = (Math.floor(paused * 30 + 1e-6) + 1) / 30;
  expect(await clipTime(), 'the next frame').toBeCloseTo(Math.min(next, end), 6);
  await page().keyboard.press('Home');
  await page().evaluate(() => window.sinew.seek(1));
  const shown = await getPose(page());
  expect(shown.root![2], 'the root walks').not.toBe(0);
  const { field } = await openJoint(page(), 'head', 'Y');
  await field.fill('0.1');
  await field.press('Enter');
  const edited = await getPose(page());
  expect(edited).toEqual({ ...shown, joints: { ...shown.joints, head: edited.joints!['head'] } });
  expect(edited.joints!['head']![1]).toBe(0.1);
  await expect(timeline().getByRole('button', { name: 'Release the clip' })).toBeEnabled();
  await page().keyboard.press('Control+z');
  expect(await getPose(page())).toEqual(shown);
  await timeline().getByRole('button', { name: 'Release the clip' }).click();
  expect(await getPose(page())).toEqual(shown);
  await expect(timeline().getByRole('button', { name: 'Release the clip' })).toBeDisabled();
});

test('the range of a clip has its modes, and the curves shown are those of the selected joint', async () => {
  const atEnd = timeline().getByRole('combobox', { name: 'At the end' });
  await expect(atEnd.locator('option')).toHaveText(['Once', 'Loop', 'Ping-pong', 'Go on']);
  await page().getByRole('treeitem', { name: 'head', exact: true }).click();
  await timeline().getByRole('button', { name: 'Curves', exact: true }).click();
  const curves = timeline().getByRole('list', { name: 'Curves' });
  await expect(curves.getByRole('listitem')).toHaveText(['head X●', 'head Y●', 'head Z●']);
  await timeline()
    .locator('.ruler')
    .click({ position: { x: 200, y: 12 } });
  expect(await clipTime()).toBeGreaterThan(0);
  await timeline().getByRole('button', { name: 'Release the clip' }).click();
});

test('in the timeline the arrows step, and Home and End seek, wherever the focus is', async () => {
  await insectOf();
  await timeline().getByRole('button', { name: 'Play' }).focus();
  await page().keyboard.press('ArrowRight');
  expect(await clipTime()).toBeCloseTo(1 / 30, 6);
  await page().keyboard.press('End');
  expect(await clipTime()).toBe(4);
  await page().keyboard.press('Home');
  expect(await clipTime()).toBe(0);
  const mode = timeline().getByRole('combobox', { name: 'At the end' });
  await mode.focus();
  await page().keyboard.press('End');
  expect(await clipTime(), 'a list keeps its keys').toBe(0);
  await mode.selectOption('Loop');
  await timeline().getByRole('slider', { name: 'Time' }).focus();
  await page().keyboard.press('Space');
  await expect(timeline().getByRole('button', { name: 'Pause' })).toBeVisible();
  await page().keyboard.press('Space');
  await expect(timeline().getByRole('button', { name: 'Play' })).toBeVisible();
});

test('dropping files again keeps shape, clip and time, and the clip plays on', async () => {
  await insectOf();
  await page().evaluate(() => window.sinew.morphs({ insect_breathe: 0.5 }));
  await page().evaluate(() => window.sinew.seek(1.25));
  const shown = await getPose(page());
  const image = readFileSync('public/data/insect/insect.png');
  await drop(page(), [{ name: 'insect.png', content: image }]);
  await expect(page().locator('.notice')).toHaveText('insect updated; pose and camera kept');
  expect(await page().evaluate(() => window.sinew.morphs())).toMatchObject({ insect_breathe: 0.5 });
  expect(await clipTime()).toBe(1.25);
  expect(await getPose(page())).toEqual(shown);
  await timeline().getByRole('button', { name: 'Play' }).click();
  await drop(page(), [{ name: 'insect.png', content: image }]);
  const time = await clipTime();
  await expect.poll(clipTime).not.toBe(time);
  await timeline().getByRole('button', { name: 'Release the clip' }).click();
  await page().getByRole('button', { name: 'Reset all' }).click();
});

test('choosing a character again opens it as its files have it', async () => {
  await insectOf();
  const own = await getPose(page());
  await page().evaluate(() => window.sinew.morphs({ insect_alert: 1 }));
  await page().evaluate(() => window.sinew.pose({ joints: { head: [0.3, 0, 0] } }));
  await page().evaluate(() => window.sinew.seek(2));
  await insectOf();
  expect(await getPose(page())).toEqual(own);
  expect(await page().evaluate(() => window.sinew.morphs())).toMatchObject({ insect_alert: 0 });
  expect(await clipTime()).toBe(0);
});

test('undo restores a character’s clip, whichever clip of the next character was chosen', async () => {
  await insectOf();
  const second = legAnim.replace('range 0 2', 'range 0 1');
  await drop(
    page(),
    Object.entries({ ...leg, 'leg_second.anim': second }).map(([name, content]) => ({
      name,
      content,
    })),
  );
  await timeline().getByRole('combobox', { name: 'Clip' }).selectOption({ index: 1 });
  await page().locator('canvas.scene').focus();
  await page().keyboard.press('Control+z');
  await expect(timeline().getByRole('combobox', { name: 'Clip' })).toHaveValue('0');
  await expect(timeline().locator('output')).toContainText('/ 4.00 s');
});

test('a skin, a morph and a clip that are dropped later complete a skeleton', async () => {
  await drop(page(), [{ name: 'leg.skel', content: legSkel }]);
  await expect(page().locator('.notice')).toHaveText('leg opened');
  const rest = Object.entries(leg).filter(([name]) => name !== 'leg.skel');
  await drop(
    page(),
    rest.map(([name, content]) => ({ name, content: content as string })),
  );
  await expect(page().locator('.notice')).toHaveText('leg updated; pose and camera kept');
  expect(await page().evaluate(() => window.sinew.clips.length)).toBe(1);
});

test('the insect can be saved as the files of each course, and the page lists what is lost', async () => {
  await insectOf();
  for (const [label, name] of [
    ['UCSD CSE169', 'insect-cse169.zip'],
    ['MIT 6.837', 'insect-mit.zip'],
    ['MikuMikuDance', 'insect-pmd.zip'],
  ] as const) {
    const saving = page().waitForEvent('download');
    await chooseFromMenu(page(), `Save as ${label}`);
    const saved = await saving;
    expect(saved.suggestedFilename()).toBe(name);
    await expect(page().locator('.notice')).toHaveText(/^Saved/);
    const path = await saved.path();
    await page().locator('input[type="file"]').count();
    expect(path).toBeTruthy();
  }
  await expect(page().locator('.problems')).toContainText('limits');
});
