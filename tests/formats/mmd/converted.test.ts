import { describe, expect, it } from 'vitest';
import type { Character } from '../../../src/core/character.ts';
import type { Pose } from '../../../src/core/pose.ts';
import { DofKind, type Skeleton } from '../../../src/core/skeleton.ts';
import { convertCharacter } from '../../../src/formats/convert.ts';
import { mmdOf } from '../../../src/formats/mmd/mmd-parts.ts';
import { writeMmd } from '../../../src/formats/mmd/write-character.ts';
import { poseFromJson } from '../../../src/formats/pose-json.ts';
import { poseToJson } from '../../../src/formats/write-pose-json.ts';
import { linearBlend } from '../../../src/skinning/linear-blend.ts';
import { characterOfRig, qOfValues } from '../../fixtures/character-of-rig.ts';
import type { Rig } from '../../fixtures/rig.ts';
import { randomValues, soundRigs } from '../../fixtures/rigs.ts';
import { characterFromJoints, type Freedom, type Joint } from '../../reference/kinematics.ts';
import type { Matrix } from '../../reference/matrix.ts';
import { type Influence, type Transforms } from '../../reference/skinned-vertex.ts';
import { methodOracles } from '../../reference/skinning.ts';
import { bundledIds, readBundled } from '../../support/bundled.ts';
import { largestDifference, numbersAt } from '../../support/compare.ts';
import { shown } from '../../support/diagnose.ts';
import { readOne } from '../../support/files.ts';
import { randomBetween, randomSource } from '../../support/random.ts';
import { skinVertices } from '../../support/skin-vertices.ts';
import { trianglesOf } from '../../support/triangles-of.ts';
import { skinRigByOracle } from '../../skinning/skin-rig.ts';
import { tolerances } from '../../tolerances.ts';

/** Writes the character as PMD, with the pose as POSE.json, and reads both again. */
async function through(character: Character, pose: Pose) {
  const converted = convertCharacter(character, 'mmd', pose);
  const { files, losses } = writeMmd(converted.character);
  const again = await readOne({ 'a.pmd': files[0]!.bytes });
  const json = poseToJson(converted.character.skeleton, converted.pose);
  const { value, diagnostics } = poseFromJson('p', json, again.skeleton);
  expect(diagnostics).toEqual([]);
  return { again, pose: value!, losses: shown([...converted.losses, ...losses]) };
}

const kinds = Object.fromEntries(Object.entries(DofKind).map(([kind, number]) => [number, kind]));

/** The skeleton in the plain form of the oracle, in file order, and the values of a pose. */
function plainJoints(skeleton: Skeleton, q: Float64Array) {
  const { jointOfSource, sourceIndex, parents, dofStart, dofKind, dofAxis, dofQ } = skeleton;
  const dofsOf = (joint: number): number[] =>
    Array.from({ length: dofStart[joint + 1]! - dofStart[joint]! }, (_, i) => dofStart[joint]! + i);
  const joints = Array.from(jointOfSource, (joint): Joint => {
    const parent = parents[joint]!;
    return {
      parent: parent === -1 ? -1 : sourceIndex[parent]!,
      offset: numbersAt(skeleton.restOffsets, joint, 3),
      rotation: numbersAt(skeleton.restRotations, joint, 4),
      freedoms: dofsOf(joint).map((dof) => {
        return { kind: kinds[dofKind[dof]!]!, axis: numbersAt(dofAxis, dof, 3) } as Freedom;
      }),
    };
  });
  const values = Array.from(jointOfSource, (joint) =>
    dofsOf(joint).map((dof) => [
      ...q.subarray(dofQ[dof], dofQ[dof]! + (dofKind[dof] === 2 ? 4 : 1)),
    ]),
  );
  return { joints, values };
}

/** The transforms of the source character in the pose, by the oracle. */
function transformsOf({ skeleton, skin }: Character, { q }: Pose): Transforms {
  const { joints, values } = plainJoints(skeleton, q);
  return {
    characterFromJoint: characterFromJoints(joints, values),
    jointFromBind: Array.from(skeleton.jointOfSource, (joint): Matrix => {
      const columns = skin.jointFromBind.subarray(joint * 16, joint * 16 + 16);
      return [0, 1, 2, 3].map((row) => [0, 1, 2, 3].map((column) => columns[column * 4 + row]!));
    }),
    firstRoot: 0,
  };
}

/** The two largest weights of a point, divided by their sum; one, if it has no more. */
function largestTwo({ skin, skeleton }: Character, point: number): Influence[] {
  const row: Influence[] = [];
  for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
    row.push([skeleton.sourceIndex[skin.paletteJoint[skin.entries[i]!]!]!, skin.weights[i]!]);
  }
  const two = row.sort(([, a], [, b]) => b - a).slice(0, 2);
  const sum = two.reduce((total, [, weight]) => total + weight, 0);
  return two.map(([joint, weight]) => [joint, weight / sum]);
}

function randomPose({ skeleton }: Character, seed: number): Pose {
  const random = randomSource(seed);
  return {
    q: skeleton.qRest.map((_, i) => {
      const [low, high] = [Math.max(-1.2, skeleton.qMin[i]!), Math.min(1.2, skeleton.qMax[i]!)];
      return randomBetween(random, low, high);
    }),
  };
}

describe.each(bundledIds)('the bundled character as PMD: %s', (id) => {
  it('has every vertex of a pose where its two largest weights, in hundredths, put it', async () => {
    const character = await readBundled(id);
    const pose = randomPose(character, 5);
    const { again, pose: solved, losses } = await through(character, pose);
    expect(losses.join()).not.toContain('off by');
    const transforms = transformsOf(character, pose);
    const { mesh, bounds } = character;
    const { bones, weights } = mmdOf(again)!.vertices;
    let largestRounding = 0;
    const wanted = Array.from(mesh.pointOf).flatMap((point, vertex) => {
      const two = largestTwo(character, point);
      const hundredths = weights[vertex]!;
      const written: Influence[] = [
        [bones[vertex * 2]!, hundredths / 100],
        [bones[vertex * 2 + 1]!, 1 - hundredths / 100],
      ];
      two.forEach(([joint, weight], i) => {
        const [bone, own] = written[i]!;
        if (own > 0) expect(bone).toBe(joint);
        largestRounding = Math.max(largestRounding, Math.abs(own - weight));
      });
      const position = numbersAt(mesh.positions, vertex, 3);
      const normal = numbersAt(mesh.normals, vertex, 3);
      const vertexOf = { position, normal, influences: written };
      return methodOracles['linear-blend']!.position(vertexOf, transforms);
    });
    expect(largestRounding).toBeLessThan(0.005 + 1e-6);
    const found = skinVertices(again, again.skin, solved, linearBlend).positions;
    const diagonal = Math.hypot(...[0, 1, 2].map((i) => bounds.max[i]! - bounds.min[i]!));
    expect(largestDifference(found, wanted)).toBeLessThan(tolerances.skinning * diagonal);
  });

  it('keeps its triangles, normals, texture coordinates and morphs', async () => {
    const character = await readBundled(id);
    const { again } = await through(character, { q: character.skeleton.qRest });
    const { mesh } = character;
    expect(again.mesh.positions).toEqual(mesh.positions);
    expect(again.mesh.normals).toEqual(mesh.normals);
    expect(largestDifference(again.mesh.uvs!, mesh.uvs!)).toBeLessThan(tolerances.float32);
    expect(trianglesOf(again)).toEqual(trianglesOf(character));
    const morphsOf = (each: Character) =>
      each.morphs.map(({ name, vertices, offsets }) => [name, vertices, offsets]);
    expect(morphsOf(again)).toEqual(morphsOf(character));
  });
});

/** The rig without the slides that a PMD does not have, and with two influences a point. */
function likePmd(rig: Rig): Rig {
  const isKept = (joint: Joint, kind: string): boolean => joint.parent === -1 || kind !== 'slide';
  const kept = <T>(values: readonly T[], joint: Joint): T[] =>
    values.filter((_, i) => isKept(joint, joint.freedoms[i]!.kind));
  return {
    ...rig,
    joints: rig.joints.map((joint) => ({ ...joint, freedoms: kept(joint.freedoms, joint) })),
    rest: rig.joints.map((joint, index) => kept(rig.rest[index]!, joint)),
    rows: rig.rows.map((row) => [
      [row[0]![0], 0.25],
      [row.at(-1)![0], 0.75],
    ]),
  };
}

it.each(Object.entries(soundRigs))(
  'a rig whose joints are turned at rest keeps every vertex of a pose as PMD: %s',
  async (_, rigOf) => {
    const rig = likePmd(rigOf());
    const character = characterOfRig(rig);
    const firstRoot = rig.joints.findIndex(({ parent }) => parent === -1);
    // A pose in the files moves only the first root.
    const values = randomValues(rig, 7).map((own, joint) =>
      own.map((value) =>
        value.length === 1 && rig.joints[joint]!.parent === -1 && joint !== firstRoot ? [0] : value,
      ),
    );
    const pose = { q: qOfValues(character.skeleton, values) };
    const { again, pose: solved, losses } = await through(character, pose);
    expect(losses.join()).not.toContain('off by');
    const wanted = skinRigByOracle(rig, linearBlend, values).positions;
    const found = skinVertices(again, again.skin, solved, linearBlend).positions;
    expect(largestDifference(found, wanted)).toBeLessThan(1e-5);
  },
);
