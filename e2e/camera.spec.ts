import { expect } from '@playwright/test';
import { capture, getPose, openView } from './support/app.ts';
import { cameraOf } from './support/controls.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use(coarse);

// A pointer that drags on the view moves only the camera.
const page = sharedPage((page) => openView(page, 'model=tube'));

test.beforeEach(() => page().keyboard.press('Space'));

async function drag(button: 'left' | 'middle' | 'right', right: number, down: number) {
  const { mouse } = page();
  await mouse.move(320, 240);
  await mouse.down({ button });
  await mouse.move(320 + right / 2, 240 + down / 2);
  await mouse.move(320 + right, 240 + down);
  await mouse.up({ button });
  // Moving the pointer without a button does nothing.
  await mouse.move(100, 100);
}

test('a left drag orbits, and the character turns with the hand', async () => {
  const before = await cameraOf(page());
  const pose = await getPose(page());
  await drag('left', 60, 30);
  const { azimuth, elevation, distance } = await cameraOf(page());
  expect(distance).toBe(before.distance);
  expect(azimuth).toBeLessThan(before.azimuth - 10);
  expect(elevation).toBeGreaterThan(before.elevation + 5);
  expect(await getPose(page()), 'the first drag never bends the model').toEqual(pose);
});

test('a middle drag pans, and a right drag or the wheel zooms', async () => {
  const before = await cameraOf(page());
  const picture = await capture(page());
  await drag('middle', 50, 0);
  expect(await cameraOf(page())).toEqual(before);
  expect(await capture(page())).not.toEqual(picture);
  await drag('middle', -50, 0);
  await drag('right', 0, -60);
  const near = await cameraOf(page());
  expect(near).toEqual({ ...before, distance: near.distance });
  expect(near.distance).toBeLessThan(before.distance * 0.9);
  await page().mouse.move(320, 240);
  await page().mouse.wheel(0, 300);
  await expect.poll(async () => (await cameraOf(page())).distance).toBeGreaterThan(near.distance);
});

test('the camera never turns upside down or enters the character', async () => {
  await drag('left', 0, 230);
  expect((await cameraOf(page())).elevation).toBe(89);
  await drag('right', 0, -235);
  for (let i = 0; i < 4; i++) await page().mouse.wheel(0, -3000);
  await expect.poll(async () => (await cameraOf(page())).distance).toBeGreaterThan(0);
  expect(await capture(page())).toBeDefined();
});
