import { expect } from '@playwright/test';
import { getPose, openApp, openView } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { expectPicture } from './support/pictures.ts';
import { sharedPage, test } from './support/test.ts';

const page = sharedPage(() => Promise.resolve());

const lab = () => page().locator('.ik-lab');
const button = (name: string) => lab().getByRole('button', { name });
const slider = () => lab().getByRole('slider', { name: 'Step' });
const select = (joint: string) =>
  page().locator('[role=treeitem]', { hasText: new RegExp(`${joint}$`) });

test('the view shows the chain at a step, the steps before, the target and the ellipsoid', async () => {
  await openView(page());
  await select('Left hand').dispatchEvent('click');
  await lab().locator('> summary').dispatchEvent('click');
  await lab().locator('[data-method="dls"]').waitFor({ state: 'attached' });
  await lab().getByText('Too close').dispatchEvent('click');
  for (let i = 0; i < 4; i++) {
    await lab().locator('[aria-label="Next step"]').dispatchEvent('click');
  }
  await page().evaluate(() => window.sinew.settled());
  await page().evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
  expectPicture('ik-lab', await page().locator('canvas.scene').screenshot());
});

test('the lab is found, stepped through and applied by keys alone', async () => {
  await page().setViewportSize({ width: 1000, height: 560 });
  await openApp(page());
  await page().keyboard.press('Control+k');
  await expect(page().getByRole('dialog').getByRole('combobox')).toBeFocused();
  await page().keyboard.type('IK lab');
  await page().keyboard.press('Enter');
  await expect(lab().locator('> summary')).toBeFocused();
  await expect(lab()).toContainText('Select a joint');
  await select('Left hand').click();
  await expect(lab()).toContainText('Target of Left hand');
  await slider().focus();
  await page().keyboard.press('ArrowRight');
  await expect(lab().locator('output')).toHaveText(/^1 of/);
  await page().keyboard.press('End');
  await expect(lab().locator('output')).toHaveText(/^(\d+) of \1$/);
  await expect(button('Next step')).toBeDisabled();
  await lab().getByRole('tab', { name: 'DLS' }).focus();
  await page().keyboard.press('ArrowRight');
  await expect(lab().getByRole('tab', { name: 'CCD' })).toBeFocused();
  await expect(lab().getByRole('tabpanel')).toContainText('degree of freedom');
  const before = await getPose(page());
  await button('Apply this pose').press('Enter');
  await expect(page().locator('output.notice')).toHaveText(/has the pose of step/);
  expect(await getPose(page())).not.toEqual(before);
  await page().keyboard.press('Control+z');
  expect(await getPose(page())).toEqual(before);
});

test('a straight limb is said to be one, in light and dark colors a checker accepts', async () => {
  await button('Straight limb').click();
  await expect(lab()).toContainText('The limb is almost straight');
  await lab().getByText('As a table').click();
  await expect(lab().getByRole('row')).not.toHaveCount(0);
  expect(await violations(page(), { within: '.ik-lab' })).toEqual([]);
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), { within: '.ik-lab', ...onlyColors })).toEqual([]);
});

test('a typed target is tried, and a root says why nothing moves it', async () => {
  await button('Play').click();
  await expect(button('Pause')).toBeVisible();
  const field = lab().getByRole('spinbutton', { name: 'Target Y' });
  await field.fill('9');
  await expect(lab()).toContainText('found it out of reach');
  await expect(button('Play')).toBeVisible();
  await select('Root').click();
  await expect(lab()).toContainText('Root is a root');
});
