import { expect, it } from 'vitest';
import { emptyMesh } from '../../src/core/mesh.ts';
import type { Skin } from '../../src/core/skin.ts';
import { hasCenter, restCenters } from '../../src/skinning/rest-centers/rest-centers.ts';
import { largestDifference, numbersAt } from '../support/compare.ts';
import { loadedKernel } from '../support/kernels.ts';
import { describeWithShared, sharedFloats, sharedJson } from './shared-material.ts';

const folder = 'reference/tube';
const radius = 0.25;

describeWithShared('centers of rotation of the reference tube', [folder], () => {
  const positions = sharedFloats(`${folder}/bind.f32`);
  const pointCount = positions.length / 3;
  const indices = Uint32Array.from((sharedJson(`${folder}/triangles.json`) as number[][]).flat());
  const mesh = {
    ...emptyMesh,
    pointCount,
    vertexCount: pointCount,
    pointOf: Uint32Array.from({ length: pointCount }, (_, point) => point),
    positions,
    indices,
  };
  const rows = Array.from({ length: pointCount }, (_, point) => {
    const upper = Math.min(1, Math.max(0, positions[point * 3 + 1]! - 0.5));
    return [1 - upper, upper].flatMap((weight, entry) => (weight > 0 ? [{ entry, weight }] : []));
  });
  const lengths = rows.map(({ length }) => length);
  const skin: Skin = {
    paletteJoint: Uint16Array.of(0, 1),
    // The joints stand at y = 0 and y = 1.
    jointFromBind: Float64Array.of(...translation(0), ...translation(-1)),
    start: Uint32Array.from([0, ...lengths], (_, i) =>
      lengths.slice(0, i).reduce((sum, length) => sum + length, 0),
    ),
    entries: Uint16Array.from(rows.flat(), ({ entry }) => entry),
    weights: Float32Array.from(rows.flat(), ({ weight }) => weight),
    normals: 'blended',
  };
  const exact = restCenters(mesh, skin, () => undefined);
  const clustered = restCenters(mesh, skin, () => undefined, 16);
  const { no_centre: none } = sharedJson(`${folder}/cor.json`) as { no_centre: readonly number[] };
  const expected = sharedFloats(`${folder}/cor_centres.f32`);

  it.each([
    ['exact', exact, 1e-5],
    ['clustered', clustered, radius / 100],
  ] as const)('are, %s, those of the reference', (_, centers, bound) => {
    const without = new Set(none);
    for (let point = 0; point < pointCount; point++) {
      expect(hasCenter(centers, point * 3)).toBe(!without.has(point));
      if (without.has(point)) continue;
      const found = numbersAt(centers, point, 3);
      expect(largestDifference(found, numbersAt(expected, point, 3))).toBeLessThan(bound);
    }
  });

  const { cases } = sharedJson(`${folder}/tube.json`) as {
    readonly cases: readonly { readonly name: string; readonly R: readonly number[][] }[];
  };
  const names = new Set(['twist_y_90', 'twist_y_179', 'bend_x_90']);
  it.each(cases.filter(({ name }) => names.has(name)))(
    'put the vertices of $name in place',
    ({ name, R }) => {
      const method = loadedKernel('centers-of-rotation');
      const turned = [0, 1, 2].flatMap((column) => [...R.map((row) => row[column]!), 0]);
      const joints = Float64Array.of(...translation(0), ...turned, 0, 1, 0, 1);
      const palette = new Float32Array(2 * 16);
      method.packPalette(skin, joints, palette);
      const reference = sharedFloats(`${folder}/${name}.cor.f32`);
      for (const [centers, bound] of [
        [exact, 1e-5],
        [clustered, radius / 100],
      ] as const) {
        const out = { positions: new Float32Array(pointCount * 3), normals: null };
        method.deform(mesh, skin, palette, out, { extra: centers, settings: {} });
        expect(largestDifference(out.positions, reference)).toBeLessThan(bound);
      }
    },
  );
});

/** A column-major matrix that moves along y. */
function translation(y: number): number[] {
  return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, y, 0, 1];
}
