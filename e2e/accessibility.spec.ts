import { expect } from '@playwright/test';
import { tabs } from '../src/ui/tabs.ts';
import { drop, openApp, openJoint, openTab, setPose } from './support/app.ts';
import { violations } from './support/axe.ts';
import { sharedPage, test } from './support/test.ts';

// These tests find what a checker can detect of WCAG 2.2 AA: names, roles, contrast and the order
// of headings.
const page = sharedPage((page) => openApp(page, 'model=tube'));

test('the view describes its controls and what it shows, and undo is announced', async () => {
  const view = page().getByRole('application');
  await expect(view).toHaveAccessibleName('3D view: tube');
  await expect(view).toHaveAccessibleDescription(/Arrow keys orbit/);
  await page().getByRole('treeitem', { name: 'joint 02' }).click();
  await expect(view).toHaveAccessibleName('3D view: tube, joint 02');
  await setPose(page(), { joints: { 'joint 02': [0.5, 0, 0] } });
  await page().keyboard.press('Control+z');
  await expect(page().locator('output.notice')).toHaveText('Undid: Set the pose');
  await page().keyboard.press('Control+Shift+z');
  await expect(page().locator('output.notice')).toHaveText('Redid: Set the pose');
  expect(await violations(page())).toEqual([]);
});

test('the page has no violations with an open joint and a listed problem, in light and dark colors', async () => {
  await openJoint(page(), 'joint 01', 'X');
  await drop(page(), [{ name: 'bad.skel', content: '0 0 zero -1\n' }]);
  await expect(page().locator('.problems')).toBeVisible();
  expect(await violations(page())).toEqual([]);
  // Only the colors differ in the dark theme.
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), ['color-contrast'])).toEqual([]);
});

test('clips, morphs and a joint with locked angles have no violations', async () => {
  await page().evaluate(() => window.sinew.open('insect'));
  await openTab(page(), 'animate');
  await expect(page().getByRole('region', { name: 'Timeline' })).toBeVisible();
  await openJoint(page(), 'leg_l1_tibia', 'Z');
  await page().evaluate(() => window.sinew.seek(1));
  expect(await violations(page())).toEqual([]);
});

test('the help sheet has no violations', async () => {
  await page().getByRole('button', { name: 'Show all keys' }).click();
  await expect(page().getByRole('dialog')).toBeVisible();
  expect(await violations(page())).toEqual([]);
});

test('every task, and the sheets of a narrow page, have no violations', async () => {
  await page().keyboard.press('Escape');
  for (const { id } of tabs) {
    await openTab(page(), id);
    expect(await violations(page()), id).toEqual([]);
  }
  await page().setViewportSize({ width: 390, height: 800 });
  const panels = page().getByRole('navigation', { name: 'Panels' });
  for (const button of await panels.getByRole('button').or(panels.getByRole('tab')).all()) {
    await button.click();
    expect(await violations(page())).toEqual([]);
  }
});
