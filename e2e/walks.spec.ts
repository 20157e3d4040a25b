import { expect } from '@playwright/test';
import { capture } from './support/app.ts';
import { coarse, test } from './support/test.ts';

// This walk opens, poses and saves a character by touch alone; the jobs have those by keyboard alone.
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
