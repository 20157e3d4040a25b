import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { emptyMesh } from '../../src/core/mesh.ts';
import type { Skin } from '../../src/core/skin.ts';
import { plainUse } from '../../src/skinning/method.ts';
import { inverse, multiply, translation } from '../reference/matrix.ts';
import { columnMajor, largestDifference, numbersAt } from '../support/compare.ts';
import { loadedKernel } from '../support/kernels.ts';
import { recordLines, runCommand } from '../cli/run-command.ts';
import {
  describeWithShared,
  modelFiles,
  sharedBytes,
  sharedFiles,
  sharedFloats,
  sharedJson,
} from './shared-material.ts';

recordLines();

interface ReferencePose {
  readonly index?: number;
  /** Three angles per joint, in file order. */
  readonly angles_xyz: readonly (readonly number[])[];
  readonly root_translation?: readonly number[];
  /** Vertices at which the choice of the pivot matters. */
  readonly dqs_sign_ambiguous?: readonly number[];
}

type Mirror = (value: number, axis: number) => number;
const asItIs: Mirror = (value) => value;

/** The largest difference from a reference file of what the command line writes. */
async function difference(
  files: Readonly<Record<string, string | Uint8Array>>,
  pose: ReferencePose,
  expected: Float32Array,
  options: readonly string[] = [],
  turn: Mirror = asItIs,
  move: Mirror = asItIs,
): Promise<number> {
  const joints = pose.angles_xyz.map((angles, index) => [`#${index}`, angles.map(turn)]);
  const root = (pose.root_translation ?? [0, 0, 0]).map(move);
  const text = JSON.stringify({ joints: Object.fromEntries(joints) as object, root });
  const words = [...Object.keys(files), '--pose', 'pose.json', '--method', 'dqs', ...options];
  const contents = { ...files, 'pose.json': text };
  const { folder, code } = runCommand('pose', contents, ...words, '--out', 'o.f32');
  expect(await code).toBe(0);
  const positions = new Float32Array(new Uint8Array(readFileSync(join(folder, 'o.f32'))).buffer);
  expect(positions).toHaveLength(expected.length);
  for (const vertex of pose.dqs_sign_ambiguous ?? []) {
    positions.set(numbersAt(expected, vertex, 3), vertex * 3);
  }
  return largestDifference(positions, expected);
}

const model = 'reference/skinning/Model1';

describeWithShared('dual quaternions, Model1', ['data/mit-6837', model], () => {
  const { poses } = sharedJson(`${model}/poses.json`) as { poses: readonly ReferencePose[] };

  it.each([0, 1, 2])('has every vertex of the reference: pose %#', async (which) => {
    const pose = poses[which]!;
    const expected = sharedFloats(`${model}/pose${pose.index}.dqs.f32`);
    expect(await difference(modelFiles('Model1'), pose, expected)).toBeLessThan(2e-5);
  });
});

const tube169 = 'reference/cse169/tube';

describeWithShared('dual quaternions, the tube of CSE169', ['data/cse169', tube169], () => {
  const { poses } = sharedJson(`${tube169}/poses.json`) as { poses: readonly ReferencePose[] };

  it.each([0, 1, 2, 3, 4, 5])('has every vertex of the reference: pose %#', async (which) => {
    const expected = sharedFloats(`${tube169}/pose${which}.dqs.f32`);
    const files = sharedFiles('data/cse169', 'tube.skel', 'tube.skin');
    expect(await difference(files, poses[which]!, expected)).toBeLessThan(2e-5);
  });
});

const mannequin = ['data/pmd/KAITO.pmd', 'reference/pmd'] as const;

describeWithShared('dual quaternions, KAITO of the Virtual Mannequin', mannequin, () => {
  const { poses } = sharedJson('reference/pmd/KAITO.json') as { poses: readonly ReferencePose[] };

  it.each([0, 1])('has every vertex of the reference: pose %#', async (which) => {
    const files = { 'KAITO.pmd': sharedBytes('data/pmd/KAITO.pmd') };
    const expected = sharedFloats(`reference/pmd/KAITO.pose${which}.dqs.f32`);
    const space = ['--keep-file-space'];
    const turn: Mirror = (angle, axis) => (axis === 2 ? angle : -angle);
    const move: Mirror = (value, axis) => (axis === 2 ? -value : value);
    const found = await difference(files, poses[which]!, expected, space, turn, move);
    expect(found).toBeLessThan(4e-4);
  });
});

const tube = 'reference/tube';

describeWithShared('dual quaternions, the candy wrapper', [tube], () => {
  interface Case {
    readonly name: string;
    readonly R: readonly (readonly number[])[];
  }
  const { cases, radius, segments } = sharedJson(`${tube}/tube.json`) as {
    readonly cases: readonly Case[];
    readonly radius: number;
    readonly segments: number;
  };
  const rest = sharedFloats(`${tube}/bind.f32`);
  const method = loadedKernel('dual-quaternion');

  function posed({ R }: Case): Float32Array {
    const pointCount = rest.length / 3;
    const points = Uint32Array.from({ length: pointCount }, (_, i) => i);
    const mesh = {
      ...emptyMesh,
      pointCount,
      vertexCount: pointCount,
      pointOf: points,
      positions: rest,
      normals: rest,
    };
    const joint = translation([0, 1, 0]);
    const turned = [...R.map((row) => [...row, 0]), [0, 0, 0, 1]];
    const second = [...points].map((i) => Math.min(1, Math.max(0, rest[i * 3 + 1]! - 0.5)));
    const still = translation([0, 0, 0]);
    const skin: Skin = {
      paletteJoint: Uint16Array.of(0, 1),
      jointFromBind: Float64Array.from([...columnMajor(still), ...columnMajor(inverse(joint))]),
      start: Uint32Array.from({ length: pointCount + 1 }, (_, i) => 2 * i),
      entries: Uint16Array.from({ length: 2 * pointCount }, (_, i) => i % 2),
      weights: Float32Array.from(second.flatMap((weight) => [1 - weight, weight])),
      normals: 'blended',
    };
    const palette = new Float32Array(2 * 4 * method.vec4sPerEntry(skin));
    const joints = [...columnMajor(still), ...columnMajor(multiply(joint, turned))];
    method.packPalette(skin, Float64Array.from(joints), palette);
    const positions = new Float32Array(rest.length);
    method.deform(mesh, skin, palette, { positions, normals: null }, plainUse);
    return positions;
  }

  it.each(['twist_y_90', 'twist_y_179', 'bend_x_90'])('is that of the reference: %s', (name) => {
    const positions = posed(cases.find((each) => each.name === name)!);
    expect(largestDifference(positions, sharedFloats(`${tube}/${name}.dqs.f32`))).toBeLessThan(
      1e-5,
    );
  });

  it.each(cases.filter(({ name }) => name.startsWith('twist')))(
    'keeps its radius: $name',
    (one) => {
      const positions = posed(one);
      const middle = (positions.length / 3 / segments - 1) / 2;
      for (let side = 0; side < segments; side++) {
        const [x, , z] = numbersAt(positions, middle * segments + side, 3);
        expect(Math.abs(Math.hypot(x!, z!) - radius)).toBeLessThan(1e-6);
      }
    },
  );
});
