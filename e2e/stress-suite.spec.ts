import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { expect } from '@playwright/test';
import { PNG } from 'pngjs';
import { capture, drop, getPose, openApp } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { sinew } from './support/command-line.ts';
import { madeCharacter } from './support/made-character.ts';
import { expectPicture } from './support/pictures.ts';
import { sharedPage, test } from './support/test.ts';

test.use({ viewport: { width: 800, height: 600 } });
const page = sharedPage((page) => openApp(page, 'model=tube'));

const sheet = () => page().getByRole('region', { name: 'Stress suite', exact: true });
const panel = () => page().locator('.stress');
const rows = () => sheet().locator('tbody tr');
const button = (name: string) => sheet().getByRole('button', { name, exact: true });
const small = { width: 160, height: 160 };

async function done(): Promise<void> {
  await expect(rows()).toHaveCount(6);
  await expect(sheet().getByRole('progressbar')).toHaveCount(0, { timeout: 30_000 });
}

async function saved(name: string): Promise<{ name: string; bytes: Buffer }> {
  const [file] = await Promise.all([page().waitForEvent('download'), button(name).click()]);
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

/** The table that the command line writes for the same character. */
function tableOfCommandLine(): string {
  const folder = path.resolve(import.meta.dirname, '../public/data/tube');
  const files = ['skel', 'obj', 'attach'].map((kind) => path.join(folder, `tube.${kind}.gz`));
  const out = path.join(mkdtempSync(path.join(tmpdir(), 'sinew-')), 'o.csv');
  sinew('stress', ...files, '--methods', 'lbs,dqs', '--csv', out);
  return readFileSync(out, 'utf8');
}

test('the palette runs the suite, which leaves the scene as it is', async () => {
  const before = [await getPose(page()), (await capture(page(), 'png', small)).toString('base64')];
  await page().keyboard.press('Control+k');
  await page().keyboard.type('Stress suite');
  await page().keyboard.press('Enter');
  await done();
  await expect(rows().first().getByRole('img')).toHaveCount(2);
  await expect(sheet().locator('canvas')).toHaveCount(6 * 2);
  await expect(sheet()).toContainText('6 poses of 1 joint. Differences from Linear blend');
  await expect(sheet().locator('.worst')).toHaveCount(3);
  expect([await getPose(page()), (await capture(page(), 'png', small)).toString('base64')]).toEqual(
    before,
  );
  await expect(page().locator('[data-command="undo"]').first()).toBeDisabled();
  expectPicture('stress-suite', await sheet().screenshot());
  expect(await violations(page(), { within: ':is(.stress-sheet, .stress)' })).toEqual([]);
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), { within: '.stress-sheet', ...onlyColors })).toEqual([]);
  await page().emulateMedia({ colorScheme: 'light' });
});

test('its table is that of the command line, and its pictures are saved as one', async () => {
  const table = await saved('Save table (CSV)');
  expect(table.name).toBe('tube-stress.csv');
  expect(table.bytes.toString()).toBe(tableOfCommandLine());
  const { name, bytes } = await saved('Save pictures (PNG)');
  expect(name).toBe('tube-stress.png');
  const { width, height } = PNG.sync.read(bytes);
  expect(width).toBeGreaterThan(2 * 2 * 208); // two poses beside each other
  expect(height).toBeGreaterThan(3 * 208);
});

test('a row puts its pose on the character, as one step of undo, and compares there', async () => {
  const before = await getPose(page());
  await button('By joint').click();
  const twist = rows().filter({ hasText: 'twist 90°' });
  await twist.getByRole('img').first().click();
  await expect(page().getByRole('button', { name: /^Largest difference of Dual/ })).toBeVisible();
  await expect(twist.getByRole('button')).toHaveAttribute('aria-pressed', 'true');
  expect((await getPose(page())).joints?.['joint 02']?.[1]).toBeCloseTo(Math.PI / 2, 9);
  await page().keyboard.press('Control+z');
  expect(await getPose(page())).toEqual(before);
  await expect(page().locator('[data-command="undo"]').first()).toBeDisabled();
  await page().keyboard.press('x');
});

test('the button of its section measures other methods, and can be canceled', async () => {
  await page().locator('[data-section="measures"]').scrollIntoViewIfNeeded();
  await panel()
    .getByRole('checkbox', { name: /^Linear blend/ })
    .isDisabled();
  await panel()
    .getByRole('checkbox', { name: /^Centers of rotation/ })
    .check();
  await panel()
    .getByRole('checkbox', { name: /^Linear blend/ })
    .uncheck();
  await panel().getByRole('button', { name: 'Run the suite' }).click();
  await sheet().getByRole('button', { name: 'Cancel' }).click();
  await expect(sheet().getByRole('progressbar')).toHaveCount(0);
  await expect(sheet()).toContainText('Differences from Linear blend'); // the last table stays
  const bend = panel().getByLabel('Bends up to');
  await bend.fill('0'); // no angle that joints can be tested at
  await bend.fill('45.5');
  await panel().getByRole('button', { name: 'Run the suite' }).click();
  await expect(sheet()).toContainText('Differences from Dual quaternions');
  await done();
  await expect(rows().filter({ hasText: 'bend 45.5°' })).toHaveCount(1);
  await expect(sheet().locator('canvas')).toHaveCount(6 * 2);
  await expect(page().locator('[data-command="undo"]').first()).toBeDisabled();
  await button('Close the stress suite').click();
  await expect(sheet()).toHaveCount(0);
});

test('a character with a hundred joints has all of its poses in the table, and all joints to sweep', async () => {
  await drop(page(), madeCharacter(100, 4));
  await panel().getByRole('button', { name: 'Run the suite' }).click();
  const summary = sheet().locator('.hint');
  await expect(summary).toContainText(/\d{3} poses of \d+ joints; the 12 worst/);
  const [, count, joints] = /^(\d+) poses of (\d+)/.exec(await summary.innerText())!;
  expect(Number(joints)).toBeGreaterThan(60);
  await expect(rows()).toHaveCount(Number(count));
  await button('Worst first').click();
  await expect(rows().first().getByRole('img')).toHaveCount(2);
  await sheet().getByRole('button', { name: 'Cancel' }).click();
  await page().locator('.sweep summary').click();
  await expect(page().locator('.sweep').getByLabel('Joint').locator('option')).toHaveCount(100);
});
