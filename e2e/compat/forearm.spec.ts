import { expect } from '@playwright/test';
import { drop, getPose, openApp } from '../support/app.ts';
import { model1Files, needModel1 } from '../support/shared.ts';
import { coarse, test } from '../support/test.ts';

test.use(coarse);

needModel1();

// Elbows have no child in the course's skeleton. Without a bone to a next joint, picking uses the
// skin.
test('Model1’s forearm is picked by its skin and dragged', async ({ page }) => {
  await page.setViewportSize({ width: 900, height: 500 });
  await openApp(page, 'model=tube&workspace=6.837');
  await drop(page, model1Files());
  await expect(page.locator('.notice')).toHaveText('Model1 opened');
  await page.getByRole('button', { name: 'Bone mode' }).click();
  const box = (await page.locator('canvas.scene').boundingBox())!;
  const lit = async (): Promise<string> =>
    (await page.locator('.lit-bone').allTextContents()).join();
  const places: { x: number; y: number }[] = [];
  for (let down = 0.32; down < 0.52; down += 0.05) {
    for (let across = 0.1; across < 0.44; across += 0.03) {
      const place = { x: box.x + across * box.width, y: box.y + down * box.height };
      await page.mouse.move(place.x, place.y);
      if ((await lit()).startsWith('Right elbow')) places.push(place);
    }
  }
  expect(places.length, 'places on the forearm').toBeGreaterThan(0);
  const from = places[Math.floor(places.length / 2)]!;
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const to = { x: from.x - 8, y: from.y - 18 };
  await page.mouse.move(to.x, to.y, { steps: 5 });
  await page.mouse.up();
  const pose = await getPose(page);
  expect(Object.keys(pose.joints!)).toEqual(['Right elbow']);
  await page.mouse.move(to.x, to.y + 1);
  expect(await lit(), 'the skin that was grabbed went with the pointer').toMatch(/^Right elbow/);
});
