import { readFileSync } from 'node:fs';
import path from 'node:path';
import { expect } from '@playwright/test';
import { choose, openApp, openTab, setPose } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { sinew } from './support/command-line.ts';
import { expectPicture } from './support/pictures.ts';
import { drawPlainly, sharedPage, test } from './support/test.ts';

test.use({ viewport: { width: 960, height: 900 } });
const page = sharedPage(async (page) => {
  await drawPlainly(page);
  await openApp(page, 'model=tube');
  await setPose(page, { joints: { '#2': [1.9, 0, 0] } });
});

const figure = () => page().locator('.cutting-figure');
const drawing = () => figure().getByRole('img');
const button = (name: string) => figure().getByRole('button', { name, exact: true });

async function still(): Promise<void> {
  await page().evaluate(() => window.sinew.settled());
  await page().evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
}

test('a bend is seen in profile, in the view and as a drawing', async () => {
  await page().keyboard.press('Control+k');
  await page().keyboard.type('Cutting figure');
  await page().keyboard.press('Enter');
  await expect(drawing()).toHaveAccessibleName(/: Rigid parts, Linear blend .*, Dual quaternions$/);
  await expect(figure()).not.toContainText('prepared');
  await still();
  expectPicture('cutting-figure-view', await page().locator('canvas.scene').screenshot());
  expectPicture('cutting-figure', await figure().screenshot());
  expect(await violations(page(), { within: '.cutting-figure' })).toEqual([]);
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), { within: '.cutting-figure', ...onlyColors })).toEqual([]);
});

test('it follows the pose, another plane and another method, and is saved', async () => {
  const path = () => drawing().locator('path.blend').getAttribute('d');
  const before = await path();
  await setPose(page(), { joints: { '#2': [0.4, 0, 0] } });
  await expect.poll(path).not.toBe(before);
  await button('Across the bone').click();
  await expect(button('Across the bone')).toHaveAttribute('aria-pressed', 'true');
  await expect.poll(path).toMatch(/^M[^M]+Z$/);
  await figure().getByRole('slider', { name: 'Move' }).fill('30');
  await figure().getByRole('combobox').selectOption({ label: 'Delta mush' });
  await expect(drawing()).toHaveAccessibleName(/Delta mush$/);
  // The wheel with Ctrl, keys and a drag move what is drawn; Home brings the joint back.
  const atJoint = await path();
  await drawing().focus();
  for (const key of ['+', 'ArrowLeft']) await page().keyboard.press(key);
  await expect.poll(path).not.toBe(atJoint);
  await page().keyboard.press('Home');
  await expect.poll(path).toBe(atJoint);
  await drawing().hover();
  await page().keyboard.down('Control');
  await page().mouse.wheel(0, -200);
  await page().keyboard.up('Control');
  await expect.poll(path).not.toBe(atJoint);
  const [saved] = await Promise.all([page().waitForEvent('download'), button('Save SVG').click()]);
  expect(saved.suggestedFilename()).toMatch(/-cut\.svg$/);
  expect(readFileSync(await saved.path(), 'utf8')).toContain('>Linear blend (SSD)<');
  const [picture] = await Promise.all([
    page().waitForEvent('download'),
    button('Save PNG').click(),
  ]);
  expect(
    readFileSync(await picture.path())
      .subarray(1, 4)
      .toString(),
  ).toBe('PNG');
});

test('a sweep has curves that can be read, saved and canceled, and those of the command line', async ({}, info) => {
  await setPose(page(), {});
  await page().emulateMedia({ colorScheme: 'light' });
  await openTab(page(), 'deform');
  const panel = page().locator('.sweep');
  const volume = panel.getByRole('img', { name: /^Volume/ });
  await panel.locator('> summary').click();
  await expect(volume).toHaveAccessibleName(
    'Volume while joint 02 turns about X: lbs at least 91.5 %, dqs at least 99.9 %',
  );
  await expect(panel.getByRole('img', { name: /^Cross-section/ })).toHaveAccessibleName(
    /lbs at least 0\.0 %/,
  );
  expectPicture('sweep', await panel.locator('figure').first().screenshot());
  await panel.getByText('As a table').click();
  const table = panel.getByRole('region', { name: 'Volume and section by angle' });
  await expect(table.getByRole('row')).toHaveCount(38);
  await expect(table.getByRole('row', { name: /^0°/ })).toHaveText(/(100\.0 %){4}$/);
  expect(await violations(page(), { within: '.sweep' })).toEqual([]);
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), { within: '.sweep', ...onlyColors })).toEqual([]);

  const saved = async (name: string): Promise<string> => {
    const download = page().waitForEvent('download');
    await panel.getByRole('button', { name }).click();
    return readFileSync(await (await download).path(), 'utf8');
  };
  const folder = path.resolve(import.meta.dirname, '../public/data/tube');
  const inputs = ['skel', 'obj', 'attach'].map((kind) => path.join(folder, `tube.${kind}.gz`));
  const out = info.outputPath('sweep.csv');
  const words = ['--joint', '#2', '--axis', 'x', '--methods', 'lbs,dqs', '--csv', out];
  sinew('sweep', ...inputs, ...words);
  expect(await saved('Save table')).toBe(readFileSync(out, 'utf8'));
  expect((await saved('Save picture')).match(/<polyline/g)!.length).toBeGreaterThan(4);

  await panel.getByRole('combobox', { name: 'Joint' }).selectOption({ label: 'joint 01' });
  await panel.getByRole('combobox', { name: 'Axis' }).selectOption('Y');
  await expect(volume).toHaveAccessibleName(/while joint 01 turns about Y/);
  const ended = await page().evaluate(async () => {
    const find = (selector: string) => document.querySelector<HTMLElement>(`.sweep ${selector}`);
    find('.methods label:last-child input')!.click();
    while (!find('.measuring button')) await new Promise(requestAnimationFrame);
    find('.measuring button')!.click();
    await new Promise((done) => setTimeout(done, 200));
    return !find('.measuring');
  });
  expect(ended).toBe(true);
  await expect(volume).toHaveAccessibleName(/dqs at least [\d.]+ %$/);
});

test('a vertex is explained under centers of rotation and delta mush, and edited by keys', async () => {
  test.setTimeout(60_000);
  await page().emulateMedia({ colorScheme: 'light' });
  await setPose(page(), { joints: { '#2': [1.9, 0, 0] } });
  await openTab(page(), 'deform');
  const inspector = page().locator('.vertex-inspector');
  await inspector.locator('> summary').click();
  await inspector.getByRole('spinbutton', { name: /^Vertex/ }).fill('3000');
  for (const [id, label, step, names] of [
    ['centers', 'Centers of rotation · cor', /^The center by linear blend/, ['center']],
    ['mush', 'Delta mush · mush', /^Smoothed, and the turned/, ['linear blend', 'smoothed']],
  ] as const) {
    await choose(page(), 'Method', label);
    const last = inspector.getByRole('region', { name: step }).getByRole('row', { name: /^Σ/ });
    await expect(last).toHaveText(/^Σ(-?\d\.\d{4}){3}$/);
    const labels = page().locator('.ghost-labels span');
    for (const name of [/^joint 01 0\.\d+$/, /^joint 02 0\.\d+$/, ...names]) {
      await expect(labels.filter({ hasText: name })).toHaveCount(1);
    }
    await still();
    expectPicture(`inspector-${id}`, await page().locator('canvas.scene').screenshot());
  }
  const slider = inspector.getByRole('slider').first();
  const before = await slider.inputValue();
  await slider.focus();
  // A key that is held is one step of undo.
  for (let i = 0; i < 20; i++) await page().keyboard.down('ArrowRight');
  await page().keyboard.up('ArrowRight');
  await expect(slider).not.toHaveValue(before);
  await expect(inspector.locator('.uneven')).toContainText('Σ 1.1');
  await slider.blur();
  await page().keyboard.press('Control+z');
  await expect(inspector.locator('.uneven')).toHaveCount(0);
});
