import { expect, type Page, type Route } from '@playwright/test';
import { menuName, methods } from '../src/skinning/registry.ts';
import { choose, openSmallView, openTab, setPose, verify, vertices } from './support/app.ts';
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

  await box.getByRole('button', { name: 'Cancel' }).click();
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
});
