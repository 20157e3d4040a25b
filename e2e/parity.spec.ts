import { expect } from '@playwright/test';
import { kernels, normalWays, recomputedNormals } from '../src/skinning/registry.ts';
import { choose, chooseKernel, drop, openSmallView, setPose, verify } from './support/app.ts';
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

for (const { id, files } of catalogue) {
  test(`${id}: GPU and CPU agree bit for bit, with the palette in the uniform block`, async () => {
    await page().evaluate((id) => {
      window.skinRuns = [];
      return window.sinew.open(id);
    }, id);
    expect(files.length, 'files of a character').toBeGreaterThan(0);
    for (const [index, { id: kernel, label }] of kernels.entries()) {
      await chooseKernel(page(), kernel);
      expect(await verify(page()), `${label}, as it was`).toMatchObject(same);
      const jointCount = await page().evaluate(() => window.sinew.characters[0]!.joints.length);
      await setPose(page(), wildPose(jointCount, 1 + index));
      expect(await verify(page()), `${label}, in a wild pose`).toMatchObject(same);
    }
    const runs = await skinRuns(page());
    expect(await page().evaluate(() => window.wasmSkins)).toBeGreaterThan(0);
    // One run as opened, then one for each method at each of its poses.
    expect(runs.length).toBeGreaterThanOrEqual(2 * kernels.length);
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

test('textures in place of attributes and the uniform block agree as well', async () => {
  await openSmallView(page(), 'textures=palette,influences');
  for (const { id, label } of kernels) {
    await chooseKernel(page(), id);
    expect(await verify(page()), label).toMatchObject(same);
  }
  for (const { blocks, textures } of await skinRuns(page())) {
    expect(blocks).toEqual([]);
    expect(textures.toSorted()).toEqual(['influenceTexture', 'paletteTexture']);
  }
});
