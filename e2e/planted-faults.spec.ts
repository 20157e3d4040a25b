import { expect } from '@playwright/test';
import { kernelById, menuName } from '../src/skinning/registry.ts';
import type { Verification } from '../src/document/verification.ts';
import { capture, choose, openSmallView, setPose, verify } from './support/app.ts';
import { allowFaults, plantFault, plantedTexts, type Replacement } from './support/plant-fault.ts';
import { wildPose } from './support/poses.ts';
import { drawPlainly, openBundled, sharedPage, test } from './support/test.ts';

// The agreement of GPU and CPU means something only if the check can fail. Each fault is a mistake
// that skinning shaders have had, and each must show in `verify`, far above rounding.
const clearly = 1e-4;

const row = (index: number): string => `blended${index} += weight * paletteRow(entry, ${index});`;

const positionFaults: Readonly<Record<string, readonly Replacement[]>> = {
  'lanes swapped': [
    ['visit(entries.x, weights.x)', 'visit(entries.x, weights.y)'],
    ['visit(entries.y, weights.y)', 'visit(entries.y, weights.x)'],
  ],
  'an influence dropped': [['visit(entries.z, weights.z);', '']],
  'no more than four influences': [['EACH_LANE(visit, entries1, weights1)', '']],
  'translation lost': [[' + row.w;', ';']],
  'rows transposed': [
    [
      'transformVertex(blended0, blended1, blended2,',
      `transformVertex(
        vec4(blended0.x, blended1.x, blended2.x, blended0.w),
        vec4(blended0.y, blended1.y, blended2.y, blended1.w),
        vec4(blended0.z, blended1.z, blended2.z, blended2.w),`,
    ],
  ],
  'a sign flipped': [[row(0), row(0).replace('+=', '-=')]],
  'the next joint': [[row(1), row(1).replace('entry', 'entry + 1u')]],
  'no weight': [[row(2), row(2).replace('weight * ', '')]],
  'weights in eight bits': [
    ['visit(entries.x, weights.x)', 'visit(entries.x, floor(weights.x * 255.0 + 0.5) / 255.0)'],
  ],
  'four rows an entry': [['int(entry) * PALETTE_STRIDE + row]', 'int(entry) * 4 + row]']],
};

const normalFaults: Readonly<Record<string, readonly Replacement[]>> = {
  'normals by the matrix, not its cofactors': [
    ['crossInOrder(row1.xyz, row2.xyz)', 'row0.xyz'],
    ['crossInOrder(row2.xyz, row0.xyz)', 'row1.xyz'],
    ['crossInOrder(row0.xyz, row1.xyz)', 'row2.xyz'],
  ],
  'a sign flipped in the cofactors': [['a.z * b.x - a.x * b.z', 'a.x * b.z - a.z * b.x']],
  'normals of any length': [['n * (1.0 / sqrt(squared))', 'n']],
};

const page = sharedPage(async (page) => {
  await allowFaults(page);
  await drawPlainly(page);
  await openBundled(page, 'small');
  await openSmallView(page);
});

async function verifyWith(replacements: readonly Replacement[]): Promise<Verification> {
  await plantFault(page(), replacements);
  const found = await verify(page());
  const texts = replacements.map(([text]) => text);
  expect(await plantedTexts(page()), 'texts found in the shaders').toEqual(texts);
  return found;
}

test('without a fault nothing differs', async () => {
  const found = await verifyWith([[row(0), ` ${row(0)}`]]);
  expect(found).toMatchObject({ identical: true, position: 0, normal: 0 });
});

for (const [name, replacements] of Object.entries(positionFaults)) {
  test(`finds a fault in positions: ${name}`, async () => {
    const found = await verifyWith(replacements);
    expect(found.identical).toBe(false);
    expect(found.position).toBeGreaterThan(clearly);
    expect(found.vertex).toBeGreaterThan(0);
  });
}

for (const [name, replacements] of Object.entries(normalFaults)) {
  test(`finds a fault in normals only: ${name}`, async () => {
    const found = await verifyWith(replacements);
    expect(found).toMatchObject({ identical: false, position: 0 });
    expect(found.normal).toBeGreaterThan(clearly);
  });
}

test('finds a fault in the rigid method: the last joint instead of the heaviest', async () => {
  await choose(page(), 'Method', menuName(kernelById('rigid')));
  const found = await verifyWith([['weight > heaviestWeight', 'weight > 0.0']]);
  expect(found.identical).toBe(false);
  expect(found.position).toBeGreaterThan(clearly);
  await choose(page(), 'Method', menuName(kernelById('linear-blend')));
});

const dualFaults: Readonly<Record<string, Replacement>> = {
  'rotations that point away from the pivot': [
    'dotInOrder(pivot, rotation) < 0.0 ? -clamped : clamped',
    'clamped',
  ],
  'the first joint as the pivot': ['weight > pivotWeight', 'pivotWeight == 0.0'],
  'a blend that is not normalized': ['blendedDual * scale', 'blendedDual'],
  'a rotation turned back': ['xy - turned.z', 'xy + turned.z'],
};

test('finds faults in dual quaternions', async () => {
  await choose(page(), 'Method', menuName(kernelById('dual-quaternion')));
  const jointCount = await page().evaluate(() => window.sinew.characters[0]!.joints.length);
  await setPose(page(), wildPose(jointCount, 1));
  for (const [name, replacement] of Object.entries(dualFaults)) {
    const found = await verifyWith([replacement]);
    expect(found.identical, name).toBe(false);
    expect(found.position, name).toBeGreaterThan(clearly);
  }
  await choose(page(), 'Method', menuName(kernelById('linear-blend')));
});

test('the vertices that verify reads are those that are drawn', async () => {
  await verifyWith([]);
  const sound = await capture(page());
  await verifyWith(positionFaults['no weight']!);
  expect(await capture(page())).not.toEqual(sound);
  await verifyWith([]);
  expect(await capture(page())).toEqual(sound);
});
