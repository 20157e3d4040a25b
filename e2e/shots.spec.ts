import { readFileSync } from 'node:fs';
import { expect, type Page } from '@playwright/test';
import { vec3 } from 'gl-matrix';
import { PNG } from 'pngjs';
import type { CaptureOptions } from '../src/app/scripting.ts';
import { startCamera } from '../src/document/camera.ts';
import { createActor } from '../src/document/scene.ts';
import { Evaluator } from '../src/evaluation/evaluator.ts';
import { readPngText } from '../src/formats/png/text-chunk.ts';
import { pickSkin } from '../src/posing/pick-skin.ts';
import { axesOf } from '../src/view/camera.ts';
import type { PassImageId } from '../src/view/picture/make-passes.ts';
import { characterRay, rayThrough } from '../src/view/picking.ts';
import { posedTriangles } from '../src/view/posed-triangles.ts';
import { readBundled } from '../tests/support/bundled.ts';
import { bytesOf, choose, controlRow, openSmallView, setPose } from './support/app.ts';
import { expectPicture } from './support/pictures.ts';
import { drawPlainly, sharedPage, test } from './support/test.ts';

const page = sharedPage(async (page) => {
  await drawPlainly(page);
  await openSmallView(page, 'model=human');
  await setPose(page, {});
});

async function captureBy(page: Page, options: CaptureOptions): Promise<Buffer> {
  return bytesOf(await page.evaluateHandle((options) => window.sinew.capture(options), options));
}

/** Gives the view a size in CSS pixels and waits until the picture has it. */
async function resizeView(page: Page, width: number, height: number): Promise<void> {
  await page.setViewportSize({ width: width + 220, height });
  await page.evaluate(
    ([width, height]) => {
      const view = document.querySelector<HTMLElement>('#app > .view')!;
      Object.assign(view.style, { width: `${width}px`, height: `${height}px` });
    },
    [width, height],
  );
  await page.waitForFunction(
    ([width, height]) => {
      const canvas = document.querySelector('canvas')!;
      return canvas.width === width && canvas.height === height;
    },
    [width, height],
  );
}

/** Presses a button of the page, which a test's view does not show. */
async function press(page: Page, command: string): Promise<void> {
  await page.locator(`[data-command="${command}"]`).first().dispatchEvent('click');
}

async function saveBy(page: Page, act: () => Promise<void>) {
  const [download] = await Promise.all([page.waitForEvent('download'), act()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/** The share of pixels of which a byte differs by more than `most`. */
function shareOfOthers(a: PNG, b: PNG, most: number): number {
  expect([a.width, a.height]).toEqual([b.width, b.height]);
  let others = 0;
  for (let at = 0; at < a.data.length; at += 4) {
    const differs = [0, 1, 2, 3].some((i) => Math.abs(a.data[at + i]! - b.data[at + i]!) > most);
    if (differs) others++;
  }
  return (others * 4) / a.data.length;
}

test('depth, joints, normals and masks are those of the skin that a ray of the camera meets', async () => {
  const character = await readBundled('human');
  const shown = new Evaluator(createActor(1, character, 'linear-blend'));
  const size = { width: 60, height: 80 };
  const turned = { ...startCamera, distance: 2, azimuth: 0.5, elevation: 0.2 };
  for (const projection of ['perspective', 'orthographic'] as const) {
    const camera = { ...turned, projection };
    const passOf = async (pass: PassImageId, tileLimit = 200) =>
      captureBy(page(), { ...size, views: [{ camera }], pass, tileLimit });
    const depthFile = await passOf('depth', 50);
    const depths = PNG.sync.read(depthFile, { skipRescale: true }).data;
    const note = readPngText(depthFile, 'Description')!;
    const [near, span] = /: (\S+) \+ \(value - 1\) \/ 65534 \* (\S+);/
      .exec(note)!
      .slice(1)
      .map(Number);
    const [joints, normals, mask] = await Promise.all(
      (['joint', 'normal', 'mask'] as const).map(
        async (id) => PNG.sync.read(await passOf(id)).data,
      ),
    );
    const colors = new Map<number, Map<string, number>>();
    const errors: number[] = [];
    let [met, wrong] = [0, 0];
    for (let y = 0; y < size.height; y++) {
      // A third of the pixels, in slanted lines, tell as much as all.
      for (let x = y % 3; x < size.width; x += 3) {
        const at = (y * size.width + x) * 4;
        const place = [
          ((x + 0.5) / size.width) * 2 - 1,
          1 - ((y + 0.5) / size.height) * 2,
        ] as const;
        const ray = rayThrough(camera, size.width / size.height, ...place);
        const own = characterRay(shown.display, ray);
        const hit = pickSkin(character.mesh, shown.skin, posedTriangles(shown), own);
        // The GPU moves corners to a sixteenth of a pixel, which decides at outlines.
        if (depths[at]! > 0 !== (hit !== null)) wrong++;
        if (!hit || depths[at] === 0) continue;
        met++;
        if (mask![at] !== 255) wrong++;
        const distance = hit.distance * shown.display.scale;
        const point = vec3.scaleAndAdd(new Float64Array(3), ray.origin, ray.direction, distance);
        vec3.subtract(point, point, camera.target);
        const depth = camera.distance + vec3.dot(point, axesOf(camera).look);
        const read = near! + ((depths[at]! - 1) / 65_534) * span!;
        errors.push(Math.abs(read - depth));
        const normal = [0, 1, 2].map((i) => (normals![at + i]! / 255 - 0.5) * 2);
        if (Math.abs(Math.hypot(...normal) - 1) > 0.02) wrong++;
        const color = joints!.subarray(at, at + 3).join();
        const ofJoint = colors.get(hit.joint!) ?? new Map<string, number>();
        colors.set(hit.joint!, ofJoint.set(color, (ofJoint.get(color) ?? 0) + 1));
      }
    }
    expect(met, 'pixels of the character').toBeGreaterThan(250);
    expect(wrong / met, 'pixels of the outline').toBeLessThan(0.02);
    errors.sort((a, b) => a - b);
    const [median, most] = [0.5, 0.98].map((part) => errors[Math.floor(part * met)]!);
    expect(median).toBeLessThan(2e-4);
    expect(most, 'but where depth changes in steps').toBeLessThan(5e-3);
    const usual = [...colors.values()].map((found) =>
      [...found].reduce((most, each) => (each[1] > most[1] ? each : most)),
    );
    expect(new Set(usual.map(([color]) => color)).size, 'a color each').toBe(colors.size);
    const agreeing = usual.reduce((sum, [, count]) => sum + count, 0);
    expect(agreeing / met, 'pixels in the color of their joint').toBeGreaterThan(0.99);
  }
});

test('the inside of the frame is what is saved, and the same from windows of every size', async () => {
  await resizeView(page(), 500, 500);
  const before = await captureBy(page(), {});
  await press(page(), 'add-shot');
  expect(PNG.sync.read(await captureBy(page(), {})).data, 'nothing moves').toEqual(
    PNG.sync.read(before).data,
  );
  // At this size the frame lies on whole pixels. The backdrop is a gradient over the picture.
  const view = PNG.sync.read(await captureBy(page(), { background: false }));
  const frame = new PNG({ width: 368, height: 460 });
  PNG.bitblt(view, frame, 66, 20, 368, 460, 0, 0);
  const options = { shot: 'Shot 1', width: 368, background: false };
  const shot = PNG.sync.read(await captureBy(page(), options));
  expect(shareOfOthers(frame, shot, 2)).toBeLessThanOrEqual(1e-3);
  const box = await page().locator('.shot-frame').boundingBox();
  expect(box).toMatchObject({ x: 66, y: 20, width: 368, height: 460 });

  await choose(page(), 'Size', 'Width × height');
  await controlRow(page(), 'Width')
    .locator('input')
    .evaluate((field: HTMLInputElement) => {
      field.value = '240';
      field.dispatchEvent(new Event('input'));
    });
  const first = await saveBy(page(), () => page().keyboard.press('j'));
  expect(first.name).toBe('human-Shot 1.png');
  expect(PNG.sync.read(first.bytes)).toMatchObject({ width: 240, height: 300 });
  await resizeView(page(), 620, 260);
  const second = await saveBy(page(), () => page().keyboard.press('j'));
  expect(PNG.sync.read(second.bytes).data).toEqual(PNG.sync.read(first.bytes).data);
});

test('a shot is moved, updated, gone back to and left; every step can be undone', async () => {
  await resizeView(page(), 160, 120);
  const camera = (): Promise<Buffer> => captureBy(page(), { width: 40, height: 50 });
  const update = page().locator('.shot-bar [data-command="update-shot"]');
  const taken = await captureBy(page(), { shot: 1, width: 40 });
  expect(await update.count()).toBe(0);
  await page().keyboard.press('1');
  expect(await update.count()).toBe(1);
  await update.dispatchEvent('click');
  expect(await update.count()).toBe(0);
  expect(await captureBy(page(), { shot: 1, width: 40 })).not.toEqual(taken);
  await page().keyboard.press('Control+z');
  expect(await captureBy(page(), { shot: 1, width: 40 })).toEqual(taken);
  await page().getByTitle('Go to Shot 1').dispatchEvent('click');
  await expect(update).toHaveCount(0);
  const there = await camera();
  await press(page(), 'leave-shot');
  expect(await camera(), 'the view stays').toEqual(there);
  await expect(page().locator('.shot-frame')).toHaveCount(0);
  expect(await page().evaluate(() => window.sinew.shots)).toMatchObject([{ aspect: '4:5' }]);
});

test('a picture in tiles is the picture in one piece; passes come in one archive', async () => {
  await page().evaluate(async () => {
    await window.sinew.add('dog');
    await window.sinew.add('insect');
  });
  await page().keyboard.press('a');
  for (const samples of [1, 2]) {
    const size = { width: 201, height: 134, samples };
    const whole = PNG.sync.read(await captureBy(page(), size));
    const tiled = PNG.sync.read(await captureBy(page(), { ...size, tileLimit: 100 * samples }));
    expect(shareOfOthers(whole, tiled, 1), `${samples} samples`).toBeLessThanOrEqual(1e-3);
    expect(new Set(whole.data).size).toBeGreaterThan(50);
  }
  await page().keyboard.press('a');
  const row = controlRow(page(), 'Save with passes').locator('button');
  const { name, bytes } = await saveBy(page(), () => row.dispatchEvent('click'));
  expect(name).toMatch(/^insect.*-passes\.zip$/);
  const names = ['insect', '-depth.png', '-normal.png', '-joint.png', '-mask.png'];
  for (const file of names) expect(bytes.includes(file)).toBe(true);
});

test('a picture shows one moment, while the view shows the next', async () => {
  const options = { width: 151, height: 101, tileLimit: 60 };
  const before = await captureBy(page(), options);
  const buffers = await page().evaluate(() => window.sinew.liveObjects['buffer']);
  const picture = await page().evaluateHandle(async (options) => {
    const before = window.sinew.liveObjects['buffer'];
    const made = window.sinew.capture(options);
    // The picture holds buffers of its own.
    while (window.sinew.liveObjects['buffer'] === before) {
      await new Promise((resolve) => setTimeout(resolve));
    }
    window.sinew.pose({ root: [0, 1, 0] });
    return { made };
  }, options);
  const view = PNG.sync.read(await page().locator('canvas.scene').screenshot());
  expect(new Set(new Uint32Array(view.data.buffer)).size, 'colors').toBeGreaterThan(500);
  const made = await picture.evaluateHandle(({ made }) => made);
  expect(PNG.sync.read(await bytesOf(made)).data).toEqual(PNG.sync.read(before).data);
  expect(await captureBy(page(), options)).not.toEqual(before);
  await expect.poll(() => page().evaluate(() => window.sinew.liveObjects['buffer'])).toBe(buffers);
  await page().keyboard.press('Control+z');
});

test('three characters in a framed shot', async () => {
  await resizeView(page(), 640, 480);
  await press(page(), 'add-shot');
  await page()
    .locator('.shot-bar select')
    .evaluate((choice: HTMLSelectElement) => {
      choice.value = '3:2';
      choice.dispatchEvent(new Event('change'));
    });
  await page().keyboard.press('Home');
  await press(page(), 'update-shot');
  expectPicture('framed-shot', await captureBy(page(), { shot: 'Shot 2', width: 360, samples: 2 }));
});
