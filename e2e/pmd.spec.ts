import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { unzipSync } from 'fflate';
import { quaternionOf } from '../src/formats/ball-values.ts';
import {
  capture,
  chooseFromMenu,
  controlRow,
  drop,
  getPose,
  openApp,
  openJoint,
  openSmallView,
  setPose,
  vertices,
  verify,
} from './support/app.ts';
import { madeBones, madePmd } from './support/made-pmd.ts';
import { expectPicture } from './support/pictures.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.describe('materials', () => {
  const page = sharedPage((page) => openSmallView(page, 'model=tube'));
  const size = { width: 640, height: 480 };

  test('have their colors, highlights, transparency and images', async () => {
    await drop(page(), madePmd());
    expect(await page().evaluate(() => window.sinew.problems)).toEqual([]);
    await page().keyboard.press('Home');
    expectPicture('pmd-materials', await capture(page(), 'png', size));
    expect(await verify(page())).toMatchObject({ identical: true });
  });

  test('give way to clay and to a translucent skin, and come back', async () => {
    const dressed = await capture(page());
    const textures = controlRow(page(), 'Textures').locator('input');
    await textures.evaluate((box: HTMLInputElement) => box.click());
    const clay = await capture(page());
    expect(clay.equals(dressed)).toBe(false);
    await textures.evaluate((box: HTMLInputElement) => box.click());
    await page().keyboard.press('t');
    expectPicture('pmd-translucent', await capture(page(), 'png', size));
    await page().keyboard.press('t');
    expect((await capture(page())).equals(dressed)).toBe(true);
  });

  test('are shown in their colors without their image, which may be dropped later', async () => {
    const dressed = await capture(page());
    const [pmd, image] = madePmd();
    // Another character in between makes sure that nothing of the image remains.
    await page().evaluate(() => window.sinew.open('tube'));
    await drop(page(), [pmd]);
    const problems = await page().evaluate(() => window.sinew.problems);
    expect(problems).toMatchObject([{ severity: 'warning', expected: 'plate.png' }]);
    await page().keyboard.press('Home');
    const bare = await capture(page());
    expect(bare.equals(dressed)).toBe(false);
    await drop(page(), [image]);
    expect(await page().evaluate(() => window.sinew.problems)).toEqual([]);
    expect((await capture(page())).equals(dressed)).toBe(true);
  });

  test('look the same with a TGA image as with a PNG', async () => {
    const dressed = await capture(page());
    await drop(page(), madePmd('tga'));
    expect(await page().evaluate(() => window.sinew.problems)).toEqual([]);
    await page().keyboard.press('Home');
    expect((await capture(page())).equals(dressed)).toBe(true);
  });

  test('are shown without an image if it is a truncated TGA, which is reported', async () => {
    const [pmd, image] = madePmd('tga');
    await drop(page(), [pmd, { ...image, content: image.content.slice(0, 40) }]);
    const problemOf = () => page().evaluate(() => window.sinew.problems[0]);
    await expect.poll(problemOf).toMatchObject({
      ...{ code: 'image/unknown', file: 'plate.tga' },
      found: expect.stringMatching(/^the end of the file after \d+ of 256 pixels$/),
    });
  });
});

test('a character of another course is saved as PMD, and opens again with its shape; too large a mesh is not saved', async ({
  page,
}) => {
  await openApp(page, 'model=tube&workspace=mannequin');
  await setPose(page, { joints: { '#2': [0, 0.5, 1] } });
  const before = await vertices(page, 'cpu');
  const saving = page.waitForEvent('download');
  await chooseFromMenu(page, 'Save as MikuMikuDance');
  const saved = await saving;
  expect(saved.suggestedFilename()).toBe('tube-pmd.zip');
  await expect(page.locator('.notice')).toHaveText('Saved; what got lost is under Problems');
  await expect(page.locator('.problems')).toContainText('weights in hundredths');
  const files = Object.entries(unzipSync(readFileSync(await saved.path())));
  expect(files.map(([name]) => name)).toEqual(['tube.pmd', 'tube.pose.json']);
  await drop(
    page,
    files.map(([name, bytes]) => ({ name, content: bytes })),
  );
  await expect(page.locator('.notice')).toContainText('tube opened');
  const after = await vertices(page, 'cpu');
  const change = before.map((value, i) => Math.abs(value - after[i]!));
  // A weight changes by up to half a hundredth, and the tube is two units long.
  expect(Math.max(...change)).toBeLessThan(0.02);
  expect(Math.max(...change)).toBeGreaterThan(0);

  let isSaved = false;
  page.on('download', () => (isSaved = true));
  await drop(page, [{ name: 'many.obj', content: `${'v 0 0 0\n'.repeat(65_536)}f 1 2 3\n` }]);
  await chooseFromMenu(page, 'Save as MikuMikuDance');
  await expect(page.locator('.notice')).toHaveText('Not saved; Problems says why');
  await expect(page.locator('.problems')).toContainText('at most 65535 vertices');
  expect(isSaved).toBe(false);
});

test.describe('joints and bones', () => {
  test.use(coarse);
  const page = sharedPage(async (page) => {
    await openApp(page, 'workspace=mannequin');
    await drop(page, madePmd());
  });
  const ball = async (): Promise<unknown> => (await getPose(page())).joints?.['右肩'];
  const type = async (name: string, value: string) => {
    const { field } = await openJoint(page(), '右肩', name);
    await field.fill(value);
    await field.press('Enter');
    return field;
  };

  test.beforeEach(() => setPose(page(), {}));

  test('hovering a joint opens no panel', async () => {
    const { x, y, width, height } = (await page().locator('canvas.scene').boundingBox())!;
    await page().mouse.move(x + width / 2, y + height / 2, { steps: 8 });
    await expect(page().locator('.bone')).toHaveCount(1);
    await expect(page().locator('.bone')).not.toHaveAttribute('open');
  });

  test('a ball joint has three angles, which stay as they were set', async () => {
    await expect(page().locator('.joints .note')).toHaveText(/^R = Rx · Ry · Rz,/);
    await type('Y', '90°');
    await type('Z', '0.25');
    const x = await type('X', '4');
    expect(await ball()).toEqual(quaternionOf([4, Math.PI / 2, 0.25]));
    await expect(x).toHaveValue('4.000');
    const { field: y, slider } = await openJoint(page(), '右肩', 'Y');
    await expect(y).toHaveValue('1.571');
    await expect(slider).toHaveAttribute('aria-valuetext', '90°');
    await expect((await openJoint(page(), '右肩', 'Z')).field).toHaveValue('0.250');
    await expect(page().locator('.active-dof')).toHaveText('右肩 X 4.000 (229.2°)');
    await x.blur();
    await page().keyboard.press('Control+z');
    expect(await ball()).toEqual(quaternionOf([0, Math.PI / 2, 0.25]));
    await expect(x).toHaveValue('0.000');
    await page().keyboard.press('Control+Shift+z');
    await expect(x).toHaveValue('4.000');
  });

  test('a rotation set elsewhere is shown by the nearest angles', async () => {
    const x = await type('X', '3');
    await setPose(page(), { joints: { 右肩: [3.5, 0.5, -0.25] } });
    await expect(x).toHaveValue('3.500');
    await expect((await openJoint(page(), '右肩', 'Y')).field).toHaveValue('0.500');
    await setPose(page(), {});
    await expect(x).toHaveValue('0.000');
  });

  test('a double click resets one angle, and the button resets the joint', async () => {
    await type('X', '1');
    await type('Z', '0.5');
    const { row } = await openJoint(page(), '右肩', 'X');
    await row.locator('.lil-name').dblclick();
    expect(await ball()).toEqual(quaternionOf([0, 0, 0.5]));
    const folder = row.locator('xpath=..');
    await folder.getByRole('button', { name: 'Reset joint' }).click();
    expect(await getPose(page())).toEqual({ joints: {} });
  });

  test('angles can be searched by name; joints that translate have lengths too', async () => {
    const search = page().getByRole('searchbox', { name: 'Search degrees of freedom' });
    const rows = page().locator('.joints .lil-controller:visible .lil-slider');
    await page().locator('.joints > .lil-title').click();
    await search.fill('右肩 y');
    await expect(rows).toHaveCount(1);
    await expect(rows).toHaveAttribute('aria-label', '右肩 Y');
    await search.fill('center');
    await expect(rows).toHaveCount(6);
    await expect(rows.first()).toHaveAttribute('aria-label', 'center Move X');
    await search.fill('');
    await page().locator('.joints > .lil-title').click();
  });

  test('the panel shows the bones of the selected joint, at rest and posed', async () => {
    const panel = page().locator('.bone');
    const facts = panel.locator('dd');
    const table = (caption: string) =>
      panel.locator('table').filter({ hasText: caption }).locator('td');
    await page().keyboard.press('Escape');
    await page().getByRole('treeitem', { name: 'center' }).click();
    await expect(panel).toHaveAttribute('open');
    await expect(facts.nth(0)).toHaveText('center');
    await expect(panel.locator('option')).toHaveText(['右肩', 'other']);
    await expect(facts.nth(2)).toHaveText('5.000');
    await expect(table('T, in the world')).toHaveText(['0.000', '8.000', '0.000']);
    const axes = [
      '0.600',
      '0.800',
      '0.000',
      '0.800',
      '-0.600',
      '0.000',
      '0.000',
      '0.000',
      '-1.000',
    ];
    await expect(table('Axes at rest')).toHaveText(axes);
    await expect(table('R, to the world')).toHaveText(axes);
    await panel.getByRole('combobox', { name: 'Bone to' }).selectOption('other');
    await expect(facts.nth(2)).toHaveText('5.000');
    await expect(table('Axes at rest').first()).toHaveText('-0.800');

    await page().getByRole('treeitem', { name: '右肩' }).click();
    await expect(facts).toHaveText(['右肩', '右手首', '3.000', '561']);
    await expect(table('T, along the parent')).toHaveText(['5.000', '0.000', '0.000']);
    const atRest = ['0.600', '0.000', '-0.800', '0.800', '0.000', '0.600'];
    await expect(table('R, to the parent')).toHaveText([...atRest, '0.000', '-1.000', '0.000']);
    await setPose(page(), { joints: { 右肩: [0, 0, Math.PI / 2] } });
    const posed = ['0.800', '0.000', '0.600', '-0.600', '0.000', '0.800'];
    await expect(table('S, R as posed')).toHaveText([...posed, '0.000', '-1.000', '0.000']);
    // For a joint without a child, the panel shows the bone that ends there.
    await page().getByRole('treeitem', { name: '右手首' }).click();
    await expect(facts.first()).toHaveText('右肩');
  });

  test('the panel stays open or closed as the user leaves it', async () => {
    const panel = page().locator('.bone');
    await panel.locator('summary').click();
    await page().getByRole('treeitem', { name: '右肩' }).click();
    await expect(panel).not.toHaveAttribute('open');
    await panel.locator('summary').click();
    await expect(panel.locator('dd').first()).toHaveText('右肩');
  });

  test('bones without a mesh can be shown and posed', async () => {
    await drop(page(), [madeBones()]);
    await expect(page().locator('.notice')).toHaveText('bones opened');
    await expect(page().locator('.problems')).toContainText('its bones are shown');
    await type('X', '0.5');
    expect(await ball()).toEqual(quaternionOf([0.5, 0, 0]));
  });
});
