import { readdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { expect, it } from 'vitest';
import { channelFor, evaluateChannel } from '../../src/core/motion/channel.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { axisDofs } from '../../src/core/pose.ts';
import { readAnim } from '../../src/formats/cse169/anim.ts';
import { poseFromJson } from '../../src/formats/pose-json.ts';
import { restPose } from '../../src/core/pose.ts';
import { defaultDeformation, kernelOf } from '../../src/skinning/registry.ts';
import { loadedKernel } from '../support/kernels.ts';
import { restMesh } from '../../src/skinning/rest-mesh.ts';
import { skinVertices } from '../support/skin-vertices.ts';
import { expectPosable, expectSound } from '../support/check-character.ts';
import { largestDifference, numbersAt } from '../support/compare.ts';
import { readContents, readOne } from '../support/files.ts';
import { tolerances } from '../tolerances.ts';
import {
  describeWithShared,
  sharedBytes,
  sharedFiles,
  sharedFloats,
  sharedJson,
} from './shared-material.ts';

const data = 'data/cse169';
const reference = 'reference/cse169';

describeWithShared('every file of CSE169', [data], () => {
  const folder = resolve(import.meta.dirname, '../../../shared', data);
  const names = readdirSync(folder);

  it('is read, alone or as a folder, and stands', async () => {
    const { characters, diagnostics } = await readContents(sharedFiles(data, ...names));
    expect(characters.map(({ character }) => character.name)).toEqual([
      ...['dragon', 'head', 'test', 'triangle', 'tube', 'wasp_old'],
    ]);
    expect(diagnostics.filter(({ severity }) => severity === 'error')).toEqual([]);
    for (const { character } of characters) {
      expectSound(character);
      if (character.mesh.pointCount > 0) expectPosable(character);
    }
  });

  it('has the joints, names and boxes of the dragon, whose lines end with CR CR LF', async () => {
    const { skeleton } = await readOne(sharedFiles(data, 'dragon.skel'));
    expect(skeleton.jointCount).toBe(81);
    expect(Math.max(...skeleton.depths)).toBe(12);
    expect(new Set(skeleton.names).size).toBe(81);
    expect(new Set(skeleton.fileNames).size).toBeLessThan(81);
    expect([...skeleton.sourceIndex]).toEqual(Array.from({ length: 81 }, (_, joint) => joint));
    expect(numbersAt(skeleton.displayBoxes!, 0, 6)).toEqual([-2, -1, 0, 2, 1, 2]);
  });

  it('joins head1.morph to head.skin: at weight 1 its vertices are where the file says', async () => {
    const character = await readOne(sharedFiles(data, 'head.skel', 'head.skin', 'head1.morph'));
    const { mesh, morphs, skeleton } = character;
    expect(morphs.map(({ name, vertices }) => [name, vertices.length])).toEqual([['head1', 259]]);
    const { positions, normals } = restMesh(character, {
      ...restPose(skeleton),
      morphWeights: Float64Array.of(1),
    });
    expect(largestDifference(numbersAt(positions, 18, 3), [0.077, 0.222, -0.595])).toBeLessThan(
      tolerances.float32,
    );
    for (let vertex = 0; vertex < mesh.vertexCount; vertex++) {
      expect(Math.hypot(...numbersAt(normals, vertex, 3))).toBeCloseTo(1, 5);
    }
  });
});

interface Skeleton169 {
  readonly names: readonly string[];
  readonly parents: readonly number[];
  readonly clamped_pose: readonly (readonly number[])[];
  readonly world_positions: readonly (readonly number[])[];
  readonly world_rotations: readonly (readonly number[])[];
}

describeWithShared('test.skel', [data, `${reference}/fk-test.json`], () => {
  it('has the clamped pose and the world matrices of the reference', async () => {
    const { skeleton } = await readOne(sharedFiles(data, 'test.skel'));
    const expected = (sharedJson(`${reference}/fk-test.json`) as Record<string, Skeleton169>)[
      'test.skel'
    ]!;
    expect(skeleton.names).toEqual(expected.names);
    expect([...skeleton.parents]).toEqual(expected.parents);
    const world = jointMatrices(skeleton, skeleton.qRest);
    expected.clamped_pose.forEach((angles, joint) => {
      const pose = [0, 0, 0];
      for (const { kind, axis, index } of axisDofs(skeleton, joint)) {
        if (kind === 1) pose[axis] = skeleton.qRest[index]!;
      }
      expect(pose).toEqual(angles);
      const columns = [0, 1, 2, 3].map((column) => numbersAt(world, joint * 4 + column, 4));
      const rotation = [0, 1, 2].flatMap((row) => [0, 1, 2].map((c) => columns[c]![row]!));
      const bound = tolerances.referenceMatrices;
      expect(largestDifference(rotation, expected.world_rotations[joint]!)).toBeLessThan(bound);
      expect(
        largestDifference(columns[3]!.slice(0, 3), expected.world_positions[joint]!),
      ).toBeLessThan(bound);
    });
  });
});

interface TubePose {
  readonly name: string;
  readonly angles_xyz: readonly (readonly number[])[];
  readonly root_translation: readonly number[];
}

describeWithShared('the tube of CSE169, posed', [data, `${reference}/tube`], () => {
  it.each([0, 1, 2, 3, 4, 5])(
    'has every vertex and normal of the reference: pose %#',
    async (i) => {
      const character = await readOne(sharedFiles(data, 'tube.skel', 'tube.skin'));
      const { poses } = sharedJson(`${reference}/tube/poses.json`) as { poses: TubePose[] };
      const { angles_xyz: angles, root_translation: root } = poses[i]!;
      const joints = Object.fromEntries(angles.map((triple, joint) => [`#${joint}`, triple]));
      const pose = poseFromJson('pose', { joints, root }, character.skeleton).value!;
      const posed = skinVertices(
        character,
        character.skin,
        pose,
        loadedKernel(kernelOf(defaultDeformation(character)).id),
      );
      const positions = sharedFloats(`${reference}/tube/pose${i}.lbs.f32`);
      const normals = sharedFloats(`${reference}/tube/pose${i}.normals.f32`);
      expect(positions).toHaveLength(240 * 3);
      expect(largestDifference(posed.positions, positions)).toBeLessThan(1e-5);
      expect(largestDifference(posed.normals, normals)).toBeLessThan(1e-4);
    },
  );
});

interface Sampled {
  readonly range: readonly number[];
  readonly times: readonly number[];
  readonly channels: readonly {
    readonly extrapolate: readonly string[];
    readonly tangents: readonly (readonly number[])[];
    readonly values: readonly number[];
  }[];
}

describeWithShared('sample.anim', [data, 'reference/splines/anim-sample.json'], () => {
  const { sample } = sharedJson('reference/splines/anim-sample.json') as { sample: Sampled };
  const clip = readAnim('sample.anim', sharedBytes(`${data}/sample.anim`)).value!;

  it.each([0, 1, 2])('has the values of the reference, inside and outside its keys: %#', (i) => {
    const channel = channelFor(clip.channels[i]!);
    const { values, tangents } = sample.channels[i]!;
    expect(sample.times.length).toBeGreaterThan(80);
    const found = sample.times.map((time) => evaluateChannel(channel, time));
    expect(largestDifference(found, values)).toBeLessThan(1e-5);
    const slopes = tangents.map(([into]) => into!);
    expect(largestDifference(channel.slopesIn, slopes)).toBeLessThan(1e-9);
  });

  it('has its play range', () => {
    expect([clip.start, clip.end]).toEqual(sample.range);
  });
});
