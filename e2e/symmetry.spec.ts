import { expect } from '@playwright/test';
import type { PoseJson } from '../src/formats/pose-json.ts';
import { controlRow, getPose, openApp, setPose } from './support/app.ts';
import { coarse, sharedPage, test } from './support/test.ts';

// A pose is copied from one side to the other, and live symmetry poses both at once.
test.use({ viewport: { width: 1000, height: 560 }, ...coarse });
const page = sharedPage(async (page) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await openApp(page, 'model=human');
});

const notice = () => page().locator('.notice');
const row = (name: string) => page().getByRole('treeitem', { name, exact: true });
const anglesOf = (pose: PoseJson, name: string) => pose.joints?.[name] ?? [0, 0, 0];

/** Expects that a joint of the right has the mirrored angles of the left one, which has turned. */
async function expectMirrored(joint: string): Promise<void> {
  const pose = await getPose(page());
  const [x, y, z] = anglesOf(pose, `Left ${joint}`);
  expect(Math.abs(x) + Math.abs(y) + Math.abs(z)).toBeGreaterThan(0.05);
  expect(anglesOf(pose, `Right ${joint}`)).toEqual([x, 0 - y, 0 - z]);
}

test('keys copy a branch and paste it mirrored, which is one step', async () => {
  const before = await setPose(page(), { joints: { 'Left forearm': [0.3, 0.2, 0.9] } });
  await row('Left forearm').click();
  await controlRow(page(), 'Applies to').locator('select').selectOption('Branch');
  await row('Left forearm').click();
  await page().keyboard.press('Control+c');
  await expect(notice()).toHaveText('Left forearm copied');
  await page().keyboard.press('Control+Shift+v');
  await expect(notice()).toHaveText('Pose pasted mirrored');
  await expectMirrored('forearm');
  await page().keyboard.press('Control+z');
  expect(await getPose(page())).toEqual(before);
  await controlRow(page(), 'Left → right').locator('button').click();
  await expect(notice()).toHaveText('Left forearm mirrored onto Right forearm');
  await expectMirrored('forearm');
});

test('live symmetry follows a slider and a drag, each as one step', async () => {
  const before = await setPose(page(), {});
  await row('Left upper arm').click();
  await expect(page().getByText('Mirrors Right upper arm')).toBeVisible();
  const symmetry = page().getByRole('button', { name: 'Live symmetry' });
  await symmetry.click();
  await expect(symmetry).toHaveAttribute('aria-pressed', 'true');
  await page().getByRole('slider', { name: 'Left upper arm Z' }).first().focus();
  await page().keyboard.press('PageUp');
  await expectMirrored('upper arm');
  const turned = await getPose(page());
  await page().keyboard.press('Control+z');
  expect(await getPose(page())).toEqual(before);
  await page().keyboard.press('Control+Shift+z');

  await page().keyboard.press('m');
  const canvas = (await page().locator('canvas.scene').boundingBox())!;
  const at = await armPlace(canvas);
  await page().mouse.move(at.x, at.y);
  await page().mouse.down();
  await page().mouse.move(at.x + 10, at.y - 40, { steps: 3 });
  await page().mouse.up();
  const dragged = await getPose(page());
  expect(dragged).not.toEqual(turned);
  const joint = ['upper arm', 'forearm', 'hand'].find(
    (name) =>
      JSON.stringify(anglesOf(dragged, `Left ${name}`)) !==
      JSON.stringify(anglesOf(turned, `Left ${name}`)),
  );
  await expectMirrored(joint!);
  await page().keyboard.press('Control+z');
  expect(await getPose(page())).toEqual(turned);
});

/** A place on the left arm, which is the right one of the picture. */
async function armPlace(canvas: { x: number; y: number; width: number; height: number }) {
  // The likely places come first.
  for (const down of [0.35, 0.4, 0.3, 0.45, 0.25]) {
    for (let across = 0.55; across < 0.7; across += 0.01) {
      const x = canvas.x + canvas.width * across;
      const y = canvas.y + canvas.height * down;
      await page().mouse.move(x, y);
      await page().evaluate(() => new Promise((resolve) => requestAnimationFrame(resolve)));
      const label = (await page().locator('.lit-bone').allTextContents()).join();
      if (/^Left (upper arm|forearm)/.test(label)) return { x, y };
    }
  }
  throw new Error('no arm is under the pointer');
}
