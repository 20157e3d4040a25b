import { beforeAll, expect, it } from 'vitest';
import { bonesOf } from '../../src/core/bones.ts';
import type { Character } from '../../src/core/character.ts';
import { largestInfluenceCount } from '../../src/core/skin.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { poseFromJson } from '../../src/formats/pose-json.ts';
import { writeMit } from '../../src/formats/mit/write-character.ts';
import { largestBindError } from '../../src/skinning/bind-error.ts';
import { linearBlend } from '../../src/skinning/linear-blend.ts';
import { recomputeNormals } from '../../src/skinning/welded-normals.ts';
import type { FaceWeighting } from '../../src/core/vertex-normals.ts';
import { unit } from '../reference/matrix.ts';
import { faceWeights, meanNormal } from '../reference/normals.ts';
import { loadedKernels } from '../support/kernels.ts';
import { skinVertices } from '../support/skin-vertices.ts';
import { expectSound } from '../support/check-character.ts';
import { largestDifference, numbersAt } from '../support/compare.ts';
import { readContents, readOne } from '../support/files.ts';
import { tolerances } from '../tolerances.ts';
import { describeWithShared, modelFiles, sharedFloats, sharedJson } from './shared-material.ts';

interface ReferencePose {
  readonly index: number;
  /** Three angles per joint, in file order. */
  readonly angles_xyz: readonly (readonly number[])[];
  readonly root_translation: readonly number[];
  readonly files: { readonly lbs: string };
  readonly joint_world_positions: readonly (readonly number[])[];
}

const data = 'data/mit-6837';
const reference = 'reference/skinning/Model1';

const courseNames = [
  ...['Root', 'Chest', 'Waist', 'Neck', 'Right hip', 'Right leg', 'Right knee', 'Right foot'],
  ...['Left hip', 'Left leg', 'Left knee', 'Left foot', 'Right collarbone', 'Right shoulder'],
  ...['Right elbow', 'Left collarbone', 'Left shoulder', 'Left elbow'],
];

describeWithShared('Model1 of 6.837, posed', [data, reference], () => {
  let character: Character;
  let poses: readonly ReferencePose[];

  beforeAll(async () => {
    character = await readOne(modelFiles('Model1'));
    ({ poses } = sharedJson(`${reference}/poses.json`) as { poses: readonly ReferencePose[] });
  });

  function poseOf(reference: ReferencePose) {
    const joints = reference.angles_xyz.map((angles, index) => [`#${index}`, angles]);
    const json = { joints: Object.fromEntries(joints) as object, root: reference.root_translation };
    return poseFromJson('pose', json, character.skeleton).value!;
  }

  it.each([0, 1, 2])('has every vertex where the reference has it: pose %#', (which) => {
    const expected = sharedFloats(`${reference}/${poses[which]!.files.lbs}`);
    const { positions } = skinVertices(
      character,
      character.skin,
      poseOf(poses[which]!),
      linearBlend,
    );
    expect(expected).toHaveLength(13_336 * 3);
    expect(largestDifference(positions, expected)).toBeLessThan(tolerances.referenceFiles);
  });

  it('has every joint where the reference has it', () => {
    expect(poses).toHaveLength(3);
    for (const reference of poses) {
      const world = jointMatrices(character.skeleton, poseOf(reference).q);
      reference.joint_world_positions.forEach((expected, source) => {
        const at = character.skeleton.jointOfSource[source]! * 16 + 12;
        const bound = tolerances.referenceMatrices;
        expect(largestDifference(world.subarray(at, at + 3), expected)).toBeLessThan(bound);
      });
    }
  });

  it.each(Object.keys(faceWeights))(
    'has the normals of the oracle, recomputed from its posed faces: %s',
    (way) => {
      const { mesh } = character;
      const { positions, normals } = skinVertices(
        character,
        character.skin,
        poseOf(poses[2]!),
        linearBlend,
      );
      recomputeNormals(character, way as FaceWeighting, { positions, normals });
      const faces = Array.from(
        { length: mesh.indices.length / 3 },
        (_, face) => numbersAt(mesh.indices, face, 3) as [number, number, number],
      );
      const places = Array.from({ length: mesh.vertexCount }, (_, i) => numbersAt(positions, i, 3));
      for (let point = 0; point < mesh.pointCount; point += 271) {
        const around = faces.filter((face) => face.includes(point));
        const mean = meanNormal(around, places, (corner) => corner === point, way);
        const bound = tolerances.normals / Math.hypot(...mean);
        expect(largestDifference(numbersAt(normals, point, 3), unit(mean))).toBeLessThan(bound);
      }
    },
  );

  it('is the rest mesh at rest, within what its rows are off by', () => {
    const { skeleton, skin, mesh } = character;
    expect(largestBindError(skeleton, skin)).toBeLessThan(tolerances.bindError);
    for (const method of loadedKernels) {
      const { positions } = skinVertices(character, skin, { q: skeleton.qRest }, method);
      // Weights have four decimals, so sums are 0.9996 … 1.0003.
      expect(largestDifference(positions, mesh.positions)).toBeLessThan(4e-4);
    }
  });

  it('is the same character when written and read again', async () => {
    const { files, losses } = writeMit(character);
    expect(losses).toEqual([]);
    const written = files.map(({ path, bytes }) => [path, bytes] as const);
    expect(await readOne(Object.fromEntries(written))).toEqual(character);
  });
});

describeWithShared('Model2 of 6.837, with CRLF line ends', [`${data}/crlf`], () => {
  it('is read whole, with all its influences and names', async () => {
    const { characters, diagnostics } = await readContents(modelFiles('crlf/Model2'));
    expect(diagnostics).toEqual([]);
    expect(characters).toHaveLength(1);
    const { character } = characters[0]!;
    const { skeleton, mesh, skin } = character;
    const bones = bonesOf(character);
    expect(mesh.pointCount).toBe(13_336);
    expect(mesh.indices).toHaveLength(26_668 * 3);
    expect(largestInfluenceCount(skin)).toBe(13);
    const names = Array.from(skeleton.jointOfSource, (joint) => skeleton.names[joint]);
    expect(names).toEqual(courseNames);
    expectSound(characters[0]!.character);
    const tips = bones
      .filter(({ child }) => child === -1)
      .map(({ joint }) => skeleton.names[joint]);
    expect(tips.toSorted()).toEqual([
      ...['Left elbow', 'Left foot', 'Neck', 'Right elbow', 'Right foot'],
    ]);
  });
});
