import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { openApp, setPose } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { expectPicture } from './support/pictures.ts';
import { sharedPage, test } from './support/test.ts';

test.use({ viewport: { width: 960, height: 900 } });
const page = sharedPage(async (page) => {
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
