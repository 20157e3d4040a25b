import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { controlRow, getPose, openApp, openJoint } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { countedUser } from './support/counted-user.ts';
import type { Place } from './support/find-limb.ts';
import { coarse, sharedPage, test } from './support/test.ts';

// Keys by hand: what is edited over a clip, what records, and the whole job of a wave.
test.use({ ...coarse, viewport: { width: 1280, height: 900 } });
test.describe.configure({ timeout: 240_000 });
const page = sharedPage(async (page) => {
  await openApp(page, 'model=human');
});

const arm = 'Right forearm';
const timeline = () => page().getByRole('region', { name: 'Timeline' });
const button = (name: string) => timeline().getByRole('button', { name });
const time = () => timeline().getByRole('slider', { name: 'Time' });
const notice = () => page().locator('.notice');
/** The names of the clips, without those that come with the character. */
const clips = () =>
  page().evaluate(() =>
    window.sinew.clips.filter((name) => !['walk', 'wave', 'idle'].includes(name)),
  );
const armNow = async () => (await getPose(page())).joints?.[arm];

/** The middle of the slider that turns the forearm about its x axis. */
async function onArm(): Promise<Place> {
  const slider = page().locator(`.selected-joint [role=slider][aria-label="${arm} X"]`);
  const { x, y, width, height } = (await slider.boundingBox())!;
  return { x: x + width / 2, y: y + height / 2 };
}

/** A place on the slider of time, from 0 at the start to 1 at the end. */
async function onTime(part: number): Promise<Place> {
  const { x, y, width, height } = (await time().boundingBox())!;
  return { x: x + 8 + part * (width - 16), y: y + height / 2 };
}

test('a wave of three keys from an empty timeline, played and saved as a GIF: 15 actions at most', async () => {
  const user = countedUser(page());
  await user.click(page().locator('.top [data-tab="animate"]'));
  await user.click(timeline().getByLabel('Settings of the clip').first());
  await user.click(button('New clip'));
  await expect(timeline()).toContainText('No keys yet');

  await test.step('the arm is keyed at three times', async () => {
    await user.click(page().getByRole('treeitem', { name: arm, exact: true }));
    await user.click(button('Auto-key'));
    await expect(page().locator('.recording')).toHaveText('Auto-key');
    await user.drag(await onArm(), -20, 0);
    await expect.poll(clips).toEqual(['Motion']);
    await user.click(await onTime(0.5));
    await user.drag(await onArm(), -45, 0);
    await user.click(await onTime(1));
    await user.drag(await onArm(), -10, 0);
  });
  await test.step('it plays', async () => {
    await user.click(button('Play'));
    await expect(button('Pause')).toBeVisible();
    const start = await time().inputValue();
    await expect.poll(() => time().inputValue()).not.toBe(start);
    // This is no action of the job, and neither are the fields below: less is drawn so.
    await page().evaluate(() => window.sinew.togglePlay());
  });
  await test.step('it is saved', async () => {
    const saved = page().waitForEvent('download', { timeout: 180_000 });
    await user.click(button('Save a movie'));
    const dialog = page().getByRole('dialog');
    await user.click(dialog.getByRole('radio', { name: /GIF/ }));
    await dialog.getByLabel('Rate').fill('10');
    await dialog.getByLabel('Size').selectOption('Width × height');
    await dialog.getByRole('spinbutton', { name: 'Width pixels' }).fill('96');
    await dialog.getByRole('spinbutton', { name: 'Height pixels' }).fill('64');
    await user.click(dialog.getByRole('button', { name: 'Save', exact: true }));
    const bytes = readFileSync(await (await saved).path());
    expect(bytes.subarray(0, 6).toString('latin1')).toBe('GIF89a');
  });
  expect(user.presses).toBeLessThanOrEqual(15);
  expect(await page().evaluate(() => window.sinew.problems)).toEqual([]);

  await page().evaluate(() => window.sinew.seek(0));
  const first = await armNow();
  await page().evaluate(() => window.sinew.seek(1));
  const second = await armNow();
  expect(second).not.toEqual(first);
  await page().evaluate(() => window.sinew.seek(2));
  const third = await armNow();
  expect(third).not.toEqual(second);

  // One drag is one step with its key.
  await page().locator('canvas.scene').focus();
  await page().keyboard.press('Control+z');
  expect(await armNow()).toEqual(second);
  await page().keyboard.press('Control+z');
  await page().keyboard.press('Control+z');
  expect(await clips()).toEqual(['Motion']);
  for (let step = 0; step < 3; step++) await page().keyboard.press('Control+Shift+z');
  expect(await armNow()).toEqual(third);
  await button('Auto-key').click();
  await expect(page().locator('.recording')).toHaveCount(0);
});

test('an edit over the clip is marked, keyed by k, or dropped with a message', async () => {
  await page().evaluate(() => window.sinew.seek(0.5));
  const shown = await armNow();
  const { row, field, slider } = await openJoint(page(), arm, 'X');
  await expect(row).toHaveAttribute('data-keyed', 'animated');
  await field.fill('-0.5');
  await field.press('Enter');
  await expect(row).toHaveClass(/unkeyed/);
  await expect(slider).toHaveAttribute('aria-description', 'unkeyed');
  const edited = await armNow();
  expect(await violations(page(), { within: '.selected-joint' })).toEqual([]);

  await (await onTimeFocus()).press('Home');
  await expect(notice()).toHaveText('1 unkeyed value dropped; Undo brings it back');
  await expect(row).not.toHaveClass(/unkeyed/);
  await page().keyboard.press('Control+z');
  expect(await armNow()).toEqual(edited);
  expect(await time().inputValue()).toBe('0.5');

  await page().keyboard.press('k');
  await expect(notice()).toHaveText(`${arm} keyed at 0.50 s`);
  await expect(row).toHaveAttribute('data-keyed', 'keyed');
  expect(await armNow()).toEqual(edited);
  await page().keyboard.press('Control+z');
  await page().keyboard.press('Control+z');
  expect(await armNow()).toEqual(shown);
});

test('clips are made, named, measured and deleted beside their list', async () => {
  await page().evaluate(() => window.sinew.seek(1));
  const shown = await armNow();
  await button('Settings of the clip').click();
  const settings = page().getByRole('dialog', { name: 'Settings of the clip' });
  const type = async (label: string, text: string) => {
    await settings.getByLabel(label).fill(text);
    await settings.getByLabel(label).press('Tab');
  };
  await type('Name', 'Wave');
  await type('Ends at', '3');
  await settings.getByLabel('Frames a second').selectOption('24');
  await expect(timeline().locator('.transport output')).toContainText('/ 3.00 s');
  expect(await clips()).toEqual(['Wave']);
  await type('Ends at', '-1');
  await expect(notice()).toHaveText('A clip ends after its start');
  expect(await violations(page(), { within: '.clip-settings' })).toEqual([]);
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), { within: '.clip-settings', ...onlyColors })).toEqual([]);
  await page().emulateMedia({ colorScheme: 'light' });
  await settings.getByRole('button', { name: 'Duplicate' }).click();
  await expect.poll(clips).toEqual(['Wave', 'Wave 2']);
  await settings.getByRole('button', { name: 'New clip' }).click();
  await expect.poll(clips).toEqual(['Wave', 'Wave 2', 'Motion']);
  await settings.getByRole('button', { name: 'Delete' }).click();
  await expect.poll(clips).toEqual(['Wave', 'Wave 2']);
  await page().keyboard.press('Escape');
  expect(await armNow(), 'what was shown stays').toEqual(shown);
  for (let step = 0; step < 6; step++) await page().keyboard.press('Control+z');
  expect(await clips()).toEqual(['Motion']);
  await page().evaluate(() => window.sinew.seek(1));
  await button('Release the clip').click();
  expect(await armNow()).toEqual(shown);
  await expect(button('Release the clip')).toBeDisabled();
  await expect(controlRow(page(), 'Set a key')).toBeVisible();
});

async function onTimeFocus() {
  await time().focus();
  return time();
}
