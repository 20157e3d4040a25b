import { expect, type Page } from '@playwright/test';
import { PNG } from 'pngjs';
import type { CaptureOptions } from '../src/app/scripting.ts';
import { bytesOf, choose, openView, setPose } from './support/app.ts';
import { wildPose } from './support/poses.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use(coarse);

// Each of the views side by side has its own camera and method, and looks as if it were alone.
const page = sharedPage((page) => openView(page, 'model=human'));
const [width, height] = [211, 150];

async function captured(page: Page, options: CaptureOptions): Promise<PNG> {
  const blob = await page.evaluateHandle((options) => window.sinew.capture(options), options);
  return PNG.sync.read(await bytesOf(blob));
}

/** Columns of pixels at full height. */
function columns({ data, width: whole, height }: PNG, from: number, count: number): Buffer {
  const rows = Array.from({ length: height }, (_, y) =>
    data.subarray((y * whole + from) * 4, (y * whole + from + count) * 4),
  );
  return Buffer.concat(rows);
}

const left = { camera: { azimuth: 0.2, distance: 2.1 } } as const;
const right = { camera: { azimuth: 1.9, elevation: 0.5, distance: 2.4 }, method: 'rigid' } as const;

async function expectHalves(): Promise<void> {
  const both = await captured(page(), { width: 2 * width, height, views: [left, right] });
  const halves = [0, width].map((from) => columns(both, from, width));
  for (const [index, view] of [left, right].entries()) {
    const alone = await captured(page(), { width, height, views: [view] });
    expect(Buffer.compare(halves[index]!, alone.data), `half ${index}`).toBe(0);
  }
  expect(Buffer.compare(halves[0]!, halves[1]!)).not.toBe(0);
}

test('each half equals the picture of its view alone, pixel for pixel', async () => {
  const joints = await page().evaluate(() => window.sinew.characters[0]!.joints.length);
  await setPose(page(), wildPose(joints, 2));
  await expectHalves();
});

test('the halves are equal too with skeleton, axes and a translucent skin, and with bones as lines', async () => {
  await page().locator('canvas.scene').focus();
  for (const key of ['s', 's', 'a', 't']) await page().keyboard.press(key);
  await expectHalves();
  await choose(page(), 'Skeleton as', 'Lines');
  await expectHalves();
});

test('the page compares two methods, picks in both halves, and ends the comparison', async () => {
  const plain = await captured(page(), {});
  await page().keyboard.press('x');
  const compared = page().locator('.compared > span');
  await expect(compared).toHaveCount(2);
  expect(Buffer.compare(plain.data, (await captured(page(), {})).data)).not.toBe(0);
  const count = await page().evaluate(() => window.sinew.liveObjects);
  await page().keyboard.press('x');
  await expect
    .poll(async () => Buffer.compare((await captured(page(), {})).data, plain.data))
    .toBe(0);
  const after = await page().evaluate(() => window.sinew.liveObjects);
  expect(after['buffer']).toBeLessThan(count['buffer']!);
});
