import { expect, type Page, type Route } from '@playwright/test';
import { menuName, methods } from '../src/skinning/registry.ts';
import { choose, openSmallView, openTab, setPose, verify, vertices } from './support/app.ts';
import { mainThreadTasks } from './support/main-thread.ts';
import { wildPose } from './support/poses.ts';
import { sharedPage, test } from './support/test.ts';

// Centers of rotation are computed in a worker. Its script is held back here, so that the page can
// be looked at while it waits.
let held: Route[] | null = [];

const page = sharedPage(async (page) => {
  await page.route('**/task.worker*.js', async (route) => {
    if (held) held.push(route);
    else await route.continue();
  });
  await mainThreadTasks(page);
  await openSmallView(page, 'model=human');
});

const label = (id: string): string => menuName(methods.find((each) => each.id === id)!);

function methodOf(page: Page) {
  return page
    .locator('select', { has: page.locator('option', { hasText: label('rigid') }) })
    .first();
}

test('centers of rotation say how far they are, are canceled, and end exact', async () => {
  const box = page().locator('.preparing');
  await openTab(page(), 'deform');
  const jointCount = await page().evaluate(() => window.sinew.characters[0]!.joints.length);
  await setPose(page(), wildPose(jointCount, 5));
  const blend = await vertices(page(), 'cpu');

  await methodOf(page()).selectOption({ label: label('centers-of-rotation') }, { force: true });
  await expect(box).toContainText('Centers of rotation: 0 %. Linear blend is shown until then.');
  expect(await vertices(page(), 'cpu')).toEqual(blend);
  // Where methods are compared, its part says so as well.
  await page().keyboard.press('x');
  await expect(page().locator('.compared')).toContainText(
    'Centers of rotation (preparing; linear blend meanwhile)',
  );
  await page().keyboard.press('x');
  await expect(page().locator('.compared')).toHaveCount(0);

  const untilFree = await page().evaluate(() => {
    const from = performance.now();
    document.querySelector<HTMLElement>('.preparing button')!.click();
    return new Promise<number>((done) => setTimeout(() => done(window.workerEnded - from)));
  });
  expect(untilFree).toBeGreaterThanOrEqual(0);
  expect(untilFree, 'milliseconds until the worker is free').toBeLessThan(100);
  await expect(box).toHaveCount(0);
  await expect(methodOf(page()).locator('option:checked')).toHaveText(label('linear-blend'));
  expect(await vertices(page(), 'cpu')).toEqual(blend);

  // Another method ends it as well.
  await methodOf(page()).selectOption({ label: label('centers-of-rotation') }, { force: true });
  await expect(box).toBeVisible();
  await methodOf(page()).selectOption({ label: label('rigid') }, { force: true });
  await expect(box).toHaveCount(0);
  for (const route of held ?? []) await route.abort();
  held = null;

  await choose(page(), 'Method', label('centers-of-rotation'));
  await expect(box).toHaveCount(0);
  expect(await verify(page())).toMatchObject({ identical: true });
  const about = await vertices(page(), 'cpu');
  expect(about).not.toEqual(blend);

  // A second character with the same skin has its centers at once.
  let started = 0;
  page().on('worker', () => started++);
  await page().locator('[data-command="duplicate-character"]').first().dispatchEvent('click');
  await expect.poll(() => page().evaluate(() => window.sinew.characters.length)).toBe(2);
  await page().evaluate(() => window.sinew.settled());
  expect(await vertices(page(), 'cpu')).toEqual(about);
  expect(started).toBe(0);
});
