import { expect } from '@playwright/test';
import { startCamera } from '../src/document/camera.ts';
import type { PoseJson } from '../src/formats/pose-json.ts';
import { kernels, normalWays, recomputedNormals } from '../src/skinning/registry.ts';
import { legSkel, legSkin } from '../tests/support/cse169-files.ts';
import {
  capture,
  choose,
  chooseKernel,
  drop,
  openSmallView,
  setPose,
  verify,
  vertices,
} from './support/app.ts';
import { catalogue } from './support/catalogue.ts';
import { madeCharacter } from './support/made-character.ts';
import { wildPose } from './support/poses.ts';
import { skinRuns, watchSkinStage } from './support/skin-stage.ts';
import { sharedPage, test } from './support/test.ts';
import { watchWasmKernel, wasmKernelReady } from './support/wasm-kernel.ts';

// The shader and the strict kernel in TypeScript do the same operations in the same order, and so
// does the WebAssembly kernel, which computes here. Under SwiftShader every bit of every position
// and normal is the same.
const same = { identical: true, position: 0, vertex: 0, normal: 0 };

const page = sharedPage(async (page) => {
  await watchSkinStage(page);
  await watchWasmKernel(page);
  await openSmallView(page, 'model=tube');
  await wasmKernelReady(page);
});

// `npm run test:long -- parity` tries every method on every character. Each has some of them here,
// and the next character the next ones, so that all come up.
const methodCount = Math.min(Number(process.env['PARITY_METHODS'] ?? 2), kernels.length);

for (const [at, { id, files }] of catalogue.entries()) {
  const tried = Array.from(
    { length: methodCount },
    (_, i) => kernels[(at * methodCount + i) % kernels.length]!,
  );
  test(`${id}: GPU and CPU agree bit for bit, with the palette in the uniform block`, async () => {
    await page().evaluate((id) => {
      window.skinRuns = [];
      return window.sinew.open(id);
    }, id);
    expect(files.length, 'files of a character').toBeGreaterThan(0);
    for (const [index, { id: kernel, label }] of tried.entries()) {
      await chooseKernel(page(), kernel);
      expect(await verify(page()), `${label}, as it was`).toMatchObject(same);
      const jointCount = await page().evaluate(() => window.sinew.characters[0]!.joints.length);
      await setPose(page(), wildPose(jointCount, 1 + index));
      expect(await verify(page()), `${label}, in a wild pose`).toMatchObject(same);
    }
    const runs = await skinRuns(page());
    expect(await page().evaluate(() => window.wasmSkins)).toBeGreaterThan(0);
    // One run for each method at each of its poses, except delta mush, which the CPU computes.
    const onGpu = tried.filter(({ id: kernel }) => kernel !== 'delta-mush');
    expect(runs.length).toBeGreaterThanOrEqual(2 * onGpu.length);
    for (const { blocks, textures } of runs) {
      expect(blocks).toEqual([{ name: 'Palette', size: 16_384 }]);
      expect(textures).toEqual([]);
    }
  });
}

test('normals that are recomputed from the posed faces reach the GPU', async () => {
  await page().evaluate(() => window.sinew.open('tube'));
  const shown: string[] = [];
  for (const [index, { id, label }] of normalWays.entries()) {
    if (recomputedNormals(id) === null) continue;
    await choose(page(), 'Normals', label);
    await setPose(page(), wildPose(3, 1 + index));
    expect(await verify(page()), label).toMatchObject(same);
    shown.push(id);
  }
  expect(shown).toEqual(['faces', 'area', 'angle']);
});

const bentLeg: PoseJson = {
  joints: { '#0': [1, 0, 0.8], '#1': [0.7, -1.2, 1.5], '#2': [1.1, 0.5, -0.6] },
};

const blend = () => page().locator('[role=slider][aria-label="Dual quaternions: Blend"]');

/** Presses keys at the slider, which is out of sight in a small view, and lets the last one go. */
function moveBlend(...keys: readonly string[]): Promise<void> {
  return blend().evaluate((slider, keys) => {
    const happen = (type: string, key: string): boolean =>
      slider.dispatchEvent(new KeyboardEvent(type, { key, bubbles: true, cancelable: true }));
    for (const key of keys) happen('keydown', key);
    happen('keyup', keys.at(-1)!);
  }, keys);
}

test('dual quaternions mixed with linear blend, and of a skin that stretches', async () => {
  await drop(page(), [
    { name: 'leg.skel', content: legSkel },
    { name: 'leg.skin', content: legSkin },
  ]);
  for (const method of ['dual-quaternion', 'centers-of-rotation'] as const) {
    await chooseKernel(page(), method);
    await setPose(page(), bentLeg);
    expect(await verify(page()), method).toMatchObject(same);
  }
  for (const character of ['leg', 'tube']) {
    if (character === 'tube') await page().evaluate(() => window.sinew.open('tube'));
    await chooseKernel(page(), 'dual-quaternion');
    await setPose(page(), character === 'tube' ? wildPose(3, 2) : bentLeg);
    const alone = await vertices(page(), 'gpu');
    await moveBlend('Home', 'PageUp', 'ArrowRight');
    const share = Number(await blend().getAttribute('aria-valuenow'));
    expect(share).toBeGreaterThan(0);
    expect(share).toBeLessThan(1);
    expect(await verify(page()), `${character}, mixed`).toMatchObject(same);
    expect(await vertices(page(), 'gpu')).not.toEqual(alone);
    // The keys were one step of undo.
    await page().keyboard.press('Control+z');
    expect(await blend().getAttribute('aria-valuenow')).toBe('1.000');
    expect(await vertices(page(), 'gpu')).toEqual(alone);
    // At 0 it is linear blend, bit for bit.
    await moveBlend('Home');
    expect(await verify(page()), `${character}, without`).toMatchObject(same);
    const without = await vertices(page(), 'gpu');
    await chooseKernel(page(), 'linear-blend');
    expect(await vertices(page(), 'gpu')).toEqual(without);
  }
});

// A palette or influences that do not fit are stored in larger blocks, then in textures. These
// agree too, and show that the check above can tell the layouts apart.
const layouts = [
  { joints: 341, influences: 8, blocks: [16_384], textures: [] },
  { joints: 342, influences: 16, blocks: [65_536], textures: [] },
  { joints: 1365, influences: 12, blocks: [65_536], textures: [] },
  { joints: 1366, influences: 4, blocks: [], textures: ['paletteTexture'] },
  { joints: 40, influences: 17, blocks: [16_384], textures: ['influenceTexture'] },
  { joints: 2000, influences: 30, blocks: [], textures: ['influenceTexture', 'paletteTexture'] },
];
test('every layout of palette and influences agrees bit for bit', async () => {
  for (const { joints, influences, blocks, textures } of layouts) {
    await drop(page(), madeCharacter(joints, influences));
    await chooseKernel(page(), 'linear-blend');
    await setPose(page(), wildPose(joints, 3));
    const layout = `${joints} joints, ${influences} influences`;
    const found = await verify(page());
    expect(found, layout).toMatchObject(same);
    const run = (await skinRuns(page())).at(-1)!;
    expect(run.vertexCount).toBe(60);
    expect(
      run.blocks.map(({ size }) => size),
      layout,
    ).toEqual(blocks);
    expect(run.textures.toSorted(), layout).toEqual(textures);
  }
});

test('textures in place of attributes and the uniform block agree as well, and give the same pixels', async () => {
  const picture = () =>
    capture(page(), 'png', { width: 320, height: 240 }, [{ camera: startCamera }]);
  await page().evaluate(() => window.sinew.open('hand'));
  await chooseKernel(page(), 'linear-blend');
  const usual = await picture();
  await openSmallView(page(), 'model=hand&textures=palette,influences');
  await chooseKernel(page(), 'linear-blend');
  expect((await picture()).equals(usual)).toBe(true);
  for (const { id, label } of kernels) {
    await chooseKernel(page(), id);
    expect(await verify(page()), label).toMatchObject(same);
  }
  for (const { blocks, textures } of await skinRuns(page())) {
    expect(blocks).toEqual([]);
    expect(textures.toSorted()).toEqual(['influenceTexture', 'paletteTexture']);
  }
});
