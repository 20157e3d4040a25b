import { expect, it } from 'vitest';
import { volumeRatio } from '../../src/evaluation/comparison/volume.ts';
import { describeWithShared, sharedFloats, sharedJson } from './shared-material.ts';

const folder = 'reference/tube';
const sides = 24;

describeWithShared('the volume of the reference tube', [folder], () => {
  const rest = sharedFloats(`${folder}/bind.f32`);
  const triangles = sharedJson(`${folder}/triangles.json`) as number[][];
  const first = rest.length / 3 - sides;
  const lid = Array.from({ length: sides - 2 }, (_, i) => i + 1);
  // The tube is open; its ends, which stay as they are, are closed by flat lids.
  const lids = [
    ...lid.map((side) => [0, side + 1, side]),
    ...lid.map((side) => [first, first + side, first + side + 1]),
  ];
  const faces = [triangles, lids, lids.map((corners) => corners.toReversed())] as const;
  const closed = [
    [...faces[0], ...faces[1]],
    [...faces[0], ...faces[2]],
  ] as const;

  /** The mesh whose lids close it, whichever way the triangles of the file face. */
  function meshes() {
    return closed.map((all) => ({ positions: rest, indices: Uint32Array.from(all.flat()) }));
  }

  interface Result {
    readonly volume_ratio: number;
  }
  type Case = Readonly<Record<'lbs' | 'dqs', Result>> & { readonly name: string };
  const { cases } = sharedJson(`${folder}/tube.json`) as { readonly cases: readonly Case[] };
  const { cases: centered } = sharedJson(`${folder}/cor.json`) as {
    readonly cases: readonly (Result & { readonly name: string })[];
  };
  const rows = ['twist_y_90', 'twist_y_179', 'bend_x_90'].flatMap((name) => {
    const found = cases.find((each) => each.name === name)!;
    return [
      [name, 'lbs', found.lbs.volume_ratio],
      [name, 'dqs', found.dqs.volume_ratio],
      [name, 'cor', centered.find((each) => each.name === name)!.volume_ratio],
    ] as const;
  });

  it.each(rows)('is, for %s by %s, the expected part of that at rest', (name, method, expected) => {
    const posed = sharedFloats(`${folder}/${name}.${method}.f32`);
    const ratios = meshes().map((mesh) => volumeRatio(mesh, rest, posed));
    const found = ratios.find((ratio) => ratio !== null);
    expect(Math.abs(found! - expected)).toBeLessThan(0.005);
  });

  it('is none without lids', () => {
    const mesh = { positions: rest, indices: Uint32Array.from(triangles.flat()) };
    expect(volumeRatio(mesh, rest, rest)).toBeNull();
  });
});
