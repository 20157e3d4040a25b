import { expect } from '@playwright/test';
import {
  choose,
  controlRow,
  expectFittingCanvas,
  openApp,
  openTab,
  setPose,
} from './support/app.ts';
import { catalogue } from './support/catalogue.ts';
import { cameraOf, drawnOf } from './support/controls.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use({ ...coarse, viewport: { width: 960, height: 440 } });
const page = sharedPage(() => Promise.resolve());

const menu = () => controlRow(page(), 'Look of').locator('select');
const shading = () => controlRow(page(), 'Shading').locator('select');
const notice = () => page().locator('.notice');

// Expects what the course's program shows at its start.
async function expectCourse() {
  await openTab(page(), 'deform');
  await expect(menu().locator('option:checked')).toHaveText('6.837');
  await expect(shading().locator('option:checked')).toHaveText('Faceted');
  expect(await cameraOf(page())).toEqual({ azimuth: 0, elevation: 0, distance: 1.67 });
  expect(await drawnOf(page())).toEqual(['Skin']);
}

async function expectStudio() {
  await openTab(page(), 'deform');
  await expect(menu().locator('option:checked')).toHaveText('Studio');
  await expect(shading().locator('option:checked')).toHaveText('Smooth');
  expect(await cameraOf(page())).toMatchObject({ azimuth: 36, elevation: 9 });
  expect(await drawnOf(page())).toEqual(['Skin']);
}

test('a first visit opens the studio, and the menu switches to the course and back', async () => {
  await openApp(page());
  await expectStudio();
  const labels = await menu().locator('option').allTextContents();
  expect(labels).toEqual(['Studio', '6.837', 'CSE169', 'Mannequin']);
  const pose = await setPose(page(), { joints: { Head: [0.5, 0, 0] } });
  await menu().selectOption('6.837');
  await expectCourse();
  await page().locator('canvas.scene').focus();
  await page().keyboard.press('s');
  await choose(page(), 'Shading', 'Smooth');
  await menu().selectOption('Studio');
  await expectStudio();
  expect(await page().evaluate(() => window.sinew.pose()), 'the pose is not its business').toEqual(
    pose,
  );
});

test('the address opens a workspace', async () => {
  await openApp(page(), 'workspace=6.837');
  await expectCourse();
});

test('the address opens a bundled character, and scripts open each of them', async () => {
  await openApp(page(), `model=${catalogue[1]!.id}`);
  await expect(page().getByRole('heading', { name: catalogue[1]!.id })).toBeVisible();
  for (const { id, label } of catalogue) {
    await page().evaluate((id) => window.sinew.open(id), id);
    await expect(notice()).toHaveText(`${label} opened`);
    const [shown] = await page().evaluate(() => window.sinew.characters);
    expect(shown).toMatchObject({ name: id, selected: true });
    expect(await page().evaluate(() => window.sinew.problems)).toEqual([]);
  }
});

test('unknown names in the address give a message, and the default is opened', async () => {
  await openApp(page(), 'model=nobody&workspace=nowhere');
  await expect(notice()).toHaveText('There is no workspace "nowhere"; There is no model "nobody"');
  await expectStudio();
  const [shown] = await page().evaluate(() => window.sinew.characters);
  expect(shown).toMatchObject({ name: catalogue[0]!.id });
});

test('the page can open files without the catalogue', async ({ browser }) => {
  // This page is created separately, because the browser logs the failed answer as an error.
  const alone = await browser.newPage();
  const thrown: string[] = [];
  alone.on('pageerror', ({ message }) => thrown.push(message));
  await alone.route('**/catalogue.json', (route) => route.fulfill({ status: 404 }));
  await openApp(alone);
  await expect(alone.locator('.notice')).toContainText('the server says 404');
  await alone.getByRole('button', { name: 'File', exact: true }).click();
  await expect(alone.getByRole('menuitem', { name: 'Open files…' })).toBeEnabled();
  expect(await alone.evaluate(() => window.sinew.characters)).toEqual([]);
  expect(thrown).toEqual([]);
  await alone.close();
});

test('a narrow page has its panels as sheets, and pictures use its full width', async () => {
  await page().setViewportSize({ width: 400, height: 700 });
  await page().goto('./?model=tube');
  await page().evaluate(() => window.sinew.ready);
  const heading = page().getByRole('heading', { name: 'Characters' });
  await expect(heading).not.toBeInViewport();
  await expectFittingCanvas(page());
  expect(
    await page()
      .locator('canvas.scene')
      .evaluate(({ clientWidth }) => clientWidth),
  ).toBe(400);
  await page().getByRole('button', { name: 'Characters', exact: true }).click();
  await expect(heading).toBeInViewport();
});
