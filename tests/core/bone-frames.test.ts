import { mat4 } from 'gl-matrix';
import { describe, expect, it } from 'vitest';
import {
  type BoneFrame,
  boneFrames,
  placeBones,
  posedRotation,
  tangentAxes,
} from '../../src/core/bone-frames.ts';
import { boneWeights } from '../../src/core/bone-weights.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import type { Skeleton } from '../../src/core/skeleton.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';
import type { Joint } from '../reference/kinematics.ts';
import { largestDifference } from '../support/compare.ts';
import { readOne } from '../support/files.ts';
import { squarePmd } from '../support/pmd-files.ts';
import { randomSource, randomUnitVector } from '../support/random.ts';

const still = [0, 0, 0, 1];

function joint(parent: number, ...offset: readonly number[]): Joint {
  return { parent, offset, rotation: still, freedoms: [] };
}

function skeletonOf(joints: readonly Joint[]): Skeleton {
  const rest = joints.map(() => []);
  return characterOfRig({ joints, rest, triangles: [], points: [], rows: [] }).skeleton;
}

function expectRotation(matrix: mat4): void {
  const product = mat4.create();
  mat4.multiply(product, mat4.transpose(mat4.create(), matrix), matrix);
  expect(largestDifference(product, mat4.create())).toBeLessThan(1e-6);
  expect(mat4.determinant(matrix)).toBeCloseTo(1, 10);
}

function placeOf(world: Float64Array, index: number): Float64Array {
  return world.slice(index * 16 + 12, index * 16 + 15);
}

describe('tangentAxes', () => {
  it.each([
    [
      [0, 2, 0],
      [0, 1, 0],
      [0, 0, -1],
      [-1, 0, 0],
    ],
    [
      [3, 0, 0],
      [1, 0, 0],
      [0, 0, 1],
      [0, -1, 0],
    ],
    [
      [0, 0, -1],
      [0, 0, -1],
      [0, -1, 0],
      [-1, 0, 0],
    ],
  ])('of %j take the first of the smallest components', (along, t, n, b) => {
    const axes = tangentAxes([along[0]!, along[1]!, along[2]!]);
    expect(largestDifference(axes, [...t, 0, ...n, 0, ...b, 0, 0, 0, 0, 1])).toBe(0);
  });

  it('are a rotation for any direction', () => {
    const random = randomSource(5);
    for (let i = 0; i < 200; i++) {
      const [x, y, z] = randomUnitVector(random);
      const axes = tangentAxes([x! * 7, y! * 7, z! * 7]);
      expectRotation(axes);
      expect(largestDifference(Array.from(axes).slice(0, 3), [x!, y!, z!])).toBeLessThan(1e-15);
    }
  });
});

describe('boneFrames', () => {
  it('has a bone for each joint except the roots; its parent is the bone that ends at its source', () => {
    // The second tree comes first in the file, and its child before it.
    const skeleton = skeletonOf([
      ...[joint(1, 0, 1, 0), joint(-1, 5, 0, 0), joint(-1, 0, 0, 0)],
      ...[joint(2, 0, 2, 0), joint(3, 3, 0, 0), joint(3, 0, 0, 4)],
    ]);
    const frames = boneFrames(skeleton);
    const source = (index: number): number => skeleton.sourceIndex[index]!;
    const shown = frames.map((frame) => [
      ...[source(frame.source), source(frame.destination), frame.parent, frame.length],
    ]);
    expect(shown).toEqual([
      [1, 0, -1, 1],
      [2, 3, -1, 2],
      [3, 4, 1, 3],
      [3, 5, 1, 4],
    ]);
    expect(Array.from(frames[0]!.translation).slice(12, 15)).toEqual([5, 0, 0]);
    expect(Array.from(frames[2]!.translation).slice(12, 15)).toEqual([2, 0, 0]);
  });

  it('gives a bone without length the axes of its parent, or those of the world', () => {
    const skeleton = skeletonOf([
      ...[joint(-1, 0, 0, 0), joint(0, 0, 0, 0), joint(1, 1, 2, 3), joint(2, 0, 0, 1e-9)],
      joint(3, 0, 1, 0),
    ]);
    const frames = boneFrames(skeleton);
    for (const { axes } of frames) expectRotation(axes);
    expect(largestDifference(frames[0]!.axes, mat4.create())).toBe(0);
    expect(frames[2]!.axes).toEqual(frames[1]!.axes);
    expect(largestDifference(frames[2]!.rotation, mat4.create())).toBeLessThan(1e-15);
    const ends = placeBones(frames).map(({ end }) => end);
    expect(largestDifference(ends[3]!, [1, 3, 3])).toBeLessThan(1e-8);
  });

  it.each(Object.entries(allRigs))('puts both ends where the joints are: %s', (_, rig) => {
    const { skeleton } = characterOfRig(rig());
    const frames = boneFrames(skeleton);
    const world = jointMatrices(skeleton, skeleton.qRest);
    placeBones(frames).forEach(({ origin, end, axes }, bone) => {
      const { source, destination } = frames[bone]!;
      expectRotation(axes);
      expect(largestDifference(origin, placeOf(world, source))).toBeLessThan(1e-9);
      expect(largestDifference(end, placeOf(world, destination))).toBeLessThan(1e-7);
    });
  });
});

describe('posedRotation', () => {
  it('is R at the pose of the file', () => {
    for (const rig of Object.values(allRigs)) {
      const { skeleton } = characterOfRig(rig());
      const frames = boneFrames(skeleton);
      const world = jointMatrices(skeleton, skeleton.qRest);
      frames.forEach((frame, bone) => {
        const rotation = posedRotation(frames, bone, world);
        expect(largestDifference(rotation, frame.rotation)).toBeLessThan(1e-12);
      });
    }
  });

  it('places the bones that start at a rotated joint, and all bones below them', async () => {
    const { skeleton } = await readOne({ 'a.pmd': squarePmd });
    const frames = boneFrames(skeleton);
    const q = skeleton.qRest.slice();
    // Rotates every ball by a different angle.
    for (let at = 0, turned = 1; at + 3 < q.length; at++) {
      if (q[at + 3] !== 1) continue;
      const angle = turned++ * 0.4;
      q.set([Math.sin(angle) * 0.6, 0, Math.sin(angle) * 0.8, Math.cos(angle)], at);
      at += 3;
    }
    const world = jointMatrices(skeleton, q);
    const placed = placeBones(
      frames,
      frames.map((_, bone) => posedRotation(frames, bone, world)),
    );
    placed.forEach(({ end }, bone) => {
      const wanted = placeOf(world, frames[bone]!.destination);
      expect(largestDifference(end, wanted)).toBeLessThan(1e-12);
    });
  });
});

describe('boneWeights', () => {
  function dense(frames: readonly BoneFrame[], skin: Parameters<typeof boneWeights>[1]) {
    const { start, points, weights } = boneWeights(frames, skin);
    return frames.map((_, bone) => {
      const row = Array.from({ length: skin.start.length - 1 }, () => 0);
      for (let i = start[bone]!; i < start[bone + 1]!; i++) row[points[i]!] = weights[i]!;
      return row;
    });
  }

  it("divides a joint's weight among the bones that start there; a leaf's goes to the bone that ends there", () => {
    // Joint 0 has children 1 and 2, joint 1 has child 3, and joint 4 is alone.
    const joints = [
      ...[joint(-1, 0, 0, 0), joint(0, 1, 0, 0), joint(0, 0, 1, 0), joint(1, 1, 0, 0)],
      joint(-1, 9, 9, 9),
    ];
    const { skeleton, skin } = characterOfRig({
      joints,
      rest: joints.map(() => []),
      triangles: [[0, 1, 2]],
      points: [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
      ],
      rows: [
        [
          [0, 0.5],
          [3, 0.5],
        ],
        [
          [1, 0.25],
          [2, 0.75],
        ],
        [
          [3, 0.5],
          [4, 0.5],
        ],
      ],
    });
    // The bones to joints 1, 2 and 3.
    expect(dense(boneFrames(skeleton), skin)).toEqual([
      [0.25, 0, 0],
      [0.25, 0.75, 0],
      [0.5, 0.25, 0.5],
    ]);
  });

  it('keeps the sum of each row if no joint is without bones', () => {
    for (const rig of Object.values(allRigs)) {
      const { skeleton, skin } = characterOfRig(rig());
      const frames = boneFrames(skeleton);
      if (frames.length + 1 < skeleton.jointCount || frames.length === 0) continue;
      const columns = dense(frames, skin);
      for (let point = 0; point + 1 < skin.start.length; point++) {
        const sum = skin.weights
          .subarray(skin.start[point], skin.start[point + 1])
          .reduce((total, weight) => total + weight, 0);
        const own = columns.reduce((total, row) => total + row[point]!, 0);
        expect(Math.abs(own - sum)).toBeLessThan(1e-6);
      }
    }
  });
});
