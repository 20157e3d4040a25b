import { readFileSync } from 'node:fs';
import { expect, type Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { capture, openApp } from './support/app.ts';
import { coarse, test } from './support/test.ts';

// These walks open, pose and capture a character with only one kind of input.

// A small view is drawn faster, and its size does not matter here.
test.use({ ...coarse, viewport: { width: 960, height: 420 } });

async function focused(page: Page): Promise<string> {
  return page.evaluate(() => {
    const { activeElement: element } = document;
    return element?.getAttribute('aria-label') ?? element?.textContent ?? '';
  });
}

async function press(page: Page, keys: readonly string[]): Promise<void> {
  for (const key of keys) await page.keyboard.press(key);
}

/** Presses Tab until the wanted element has the focus. */
async function tabTo(page: Page, name: RegExp): Promise<void> {
  for (let i = 0; i < 60; i++) {
    if (name.test(await focused(page))) return;
    await page.keyboard.press('Tab');
  }
  throw new Error(`Tab does not come to ${name.source}`);
}

test('the keyboard alone opens, poses and saves', async ({ page }) => {
  await openApp(page);
  await page.keyboard.press('Control+k');
  await expect(page.getByRole('combobox', { name: /command/i })).toBeFocused();
  await page.keyboard.type('open twisting');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('heading', { name: 'tube' })).toBeVisible();
  await tabTo(page, /^Search joints$/);
  await page.keyboard.type('02');
  await page.keyboard.press('Tab');
  expect(await focused(page)).toContain('joint 02');
  // The first press selects the joint, the second goes to its sliders.
  await page.keyboard.press('Enter');
  await page.keyboard.press('Enter');
  await expect.poll(() => focused(page)).toBe('joint 02 X');
  const before = await page.evaluate(() => window.sinew.pose().joints!['joint 02']![0]);
  await press(page, ['ArrowRight', 'ArrowRight', 'Shift+ArrowRight']);
  const after = await page.evaluate(() => window.sinew.pose().joints!['joint 02']![0]);
  expect(after - before).toBeCloseTo((12 * Math.PI) / 180, 6);
  await expect(page.locator('.active-dof')).toContainText('joint 02 X');
  await page.keyboard.press('Control+z');
  const undone = await page.evaluate(() => window.sinew.pose().joints!['joint 02']![0]);
  expect(undone).toBeLessThan(after);
  // Back on the view, which takes the focus, arrows orbit and j saves.
  await page.keyboard.press('Shift+Tab');
  await page.locator('canvas.scene').focus();
  const still = await capture(page);
  await press(page, ['ArrowLeft', 'ArrowUp']);
  expect(await capture(page)).not.toEqual(still);
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('j')]);
  const { width } = PNG.sync.read(readFileSync(await download.path()));
  expect(width).toBeGreaterThan(100);
});

test.describe('with fingers only', () => {
  test.use({ ...coarse, viewport: { width: 390, height: 800 }, hasTouch: true, isMobile: true });

  test('one finger orbits, two pan and pinch, and taps do the rest', async ({ page }) => {
    await page.goto('./');
    await page.evaluate(() => window.sinew.ready);
    const client = await page.context().newCDPSession(page);
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: [number, number][]) =>
      client.send('Input.dispatchTouchEvent', {
        type,
        touchPoints: points.map(([x, y], id) => ({ x, y, id })),
      });
    const changes = async (gesture: () => Promise<unknown>): Promise<void> => {
      const before = await capture(page);
      await gesture();
      await expect.poll(async () => before.equals(await capture(page))).toBe(false);
    };
    const panels = page.getByRole('navigation', { name: 'Panels' });
    await panels.waitFor();

    await changes(async () => {
      await touch('touchStart', [[200, 400]]);
      await touch('touchMove', [[260, 420]]);
      await touch('touchEnd', []);
    });
    await changes(async () => {
      await touch('touchStart', [
        [150, 400],
        [250, 400],
      ]);
      await touch('touchMove', [
        [110, 430],
        [290, 430],
      ]);
      await touch('touchEnd', []);
    });

    await page.evaluate(() => window.sinew.open('tube'));
    await panels.getByRole('button', { name: 'Characters' }).tap();
    await page.getByRole('treeitem', { name: 'joint 02', exact: true }).tap();
    await panels.getByRole('tab', { name: 'Pose' }).tap();
    await changes(async () => {
      const slider = page.getByRole('slider', { name: 'joint 02 X' });
      const box = (await slider.boundingBox())!;
      const y = box.y + box.height / 2;
      await touch('touchStart', [[box.x + box.width * 0.5, y]]);
      await touch('touchMove', [[box.x + box.width * 0.6, y]]);
      await touch('touchMove', [[box.x + box.width * 0.9, y]]);
      await touch('touchEnd', []);
    });
    await page.locator('.lil-title').getByText('Picture', { exact: true }).tap();
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Save (j)' }).tap(),
    ]);
    expect(download.suggestedFilename()).toBe('tube.png');
  });
});
