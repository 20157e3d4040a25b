import { expect } from '@playwright/test';
import { openTab, openView } from './support/app.ts';
import { expectPicture } from './support/pictures.ts';
import { sharedPage, test } from './support/test.ts';

const page = sharedPage(async (page) => {
  await openView(page);
  await openTab(page, 'animate');
  await page.evaluate(async () => {
    window.sinew.seek(0.4, 'walk');
    await window.sinew.settled();
  });
});

const section = () => page().locator('[data-section="motion"]');
const toggle = (name: string) =>
  section()
    .getByRole('checkbox', { name, exact: true, includeHidden: true })
    .dispatchEvent('click');
const drawn = async () => {
  await page().evaluate(() => window.sinew.settled());
  await page().evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
  await page().evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
};
const picture = async () => {
  await drawn();
  return page().locator('canvas.scene').screenshot();
};

test('ghosts stand before and after the present, not in pictures, and leave nothing behind', async () => {
  const objects = () => page().evaluate(() => window.sinew.liveObjects);
  const captured = () =>
    page().evaluate(async () => {
      const blob = await window.sinew.capture({ width: 160, height: 120 });
      return [...new Uint8Array(await blob.arrayBuffer())].join();
    });
  await toggle('Ghosts');
  await expect.poll(objects).not.toEqual({});
  await drawn();
  await toggle('Ghosts');
  await drawn();
  const [before, plain] = [await objects(), await captured()];
  await toggle('Ghosts');
  expectPicture('ghosts', await picture());
  expect(await objects()).not.toEqual(before);
  expect(await captured()).toBe(plain);
  await toggle('Ghosts');
  await drawn();
  expect(await objects()).toEqual(before);
});

test('a trail shows the path of the selected limb', async () => {
  await page().evaluate(() => window.sinew.seek(1.2, 'wave'));
  await page()
    .locator('[role=treeitem]', { hasText: /Right forearm$/ })
    .dispatchEvent('click');
  await toggle('Trails');
  await expect(section()).toContainText('Drag the large dots');
  expectPicture('trails', await picture());
});

test('a key of the trail is dragged: the pose at its time follows, as one step of undo', async () => {
  const poseThere = () =>
    page().evaluate(() => {
      window.sinew.seek(0.85, 'wave');
      return window.sinew.pose();
    });
  const before = await poseThere();
  await page().evaluate(() => window.sinew.seek(1.2));
  await drawn();
  const { x, y } = (await page().locator('canvas.scene').boundingBox())!;
  // The key at the lower left of the path; see the picture above.
  await page().mouse.move(x + 189, y + 204);
  await page().mouse.down();
  await page().mouse.move(x + 150, y + 210, { steps: 3 });
  await drawn();
  await page().mouse.move(x + 120, y + 220, { steps: 3 });
  await page().mouse.up();
  const undo = page().locator('[data-command="undo"]').first();
  await expect(undo).toHaveAttribute('title', /Move Right forearm at/);
  await picture();
  await undo.dispatchEvent('click');
  await expect(undo).not.toHaveAttribute('title', /Move Right forearm at/);
  expect(await poseThere()).toEqual(before);
});
