import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { buildSkeleton } from '../../../src/core/build-skeleton.ts';
import type { Character } from '../../../src/core/character.ts';
import type { DofParts, JointParts } from '../../../src/core/character-parts.ts';
import { DiagnosticLog } from '../../../src/core/diagnostics.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { DofKind, type Skeleton } from '../../../src/core/skeleton.ts';
import { mirrorJoints, symmetryOf } from '../../../src/posing/symmetry/symmetry.ts';
import {
  identity,
  type Matrix,
  multiply,
  rotationOf,
  transform,
  transpose,
} from '../../reference/matrix.ts';
import { largestDifference } from '../../support/compare.ts';
import { randomRotation, randomSource } from '../../support/random.ts';
import { tolerances } from '../../tolerances.ts';
import { bundled, mirroredPoints, posedPoints, randomPose } from './mirror-laws.ts';

const everyJoint = ({ jointCount }: Skeleton) => Array.from({ length: jointCount }, (_, j) => j);

const mirrored = (skeleton: Skeleton, q: Float64Array): Float64Array =>
  mirrorJoints(symmetryOf(skeleton), q, q, everyJoint(skeleton)).q;

/** The bits as text, which is much faster to compare than numbers. */
const bitsOf = ({ buffer }: Float64Array): string => Buffer.from(buffer).toString('base64');

describe.each(['human', 'insect', 'hand', 'mannequin'])('a mirrored pose of %s', (id) => {
  it('is bit by bit the pose when it is mirrored again', async () => {
    const { skeleton } = await bundled(id);
    fc.assert(
      fc.property(fc.integer(), fc.double({ min: 0, max: 4, noNaN: true }), (seed, angle) => {
        const q = randomPose(skeleton, seed, angle);
        const { stopped } = mirrorJoints(symmetryOf(skeleton), q, q, everyJoint(skeleton));
        expect(stopped).toEqual([]);
        expect(bitsOf(mirrored(skeleton, mirrored(skeleton, q)))).toBe(bitsOf(q));
      }),
      { numRuns: 25 },
    );
  });
});

it('has no negative zeros, which would be other bits', async () => {
  const { skeleton } = await bundled('human');
  const none = mirrored(skeleton, new Float64Array(skeleton.qRest.length));
  expect([...none].every((value) => Object.is(value, 0))).toBe(true);
});

describe.each(['human', 'insect', 'tube', 'mannequin'])('the figure of %s', (id) => {
  it('is mirrored by a mirrored pose', async () => {
    const character = await bundled(id);
    const symmetric = symmetricPoints(character);
    for (const seed of [1, 2]) {
      const q = randomPose(character.skeleton, seed);
      const figure = posedPoints(character, q);
      const image = posedPoints(character, mirrored(character.skeleton, q));
      expect(largestOffset(figure, image, symmetric)).toBeLessThan(tolerances.mirrored);
    }
  });
});

/** Points with the same weights on the other side: those of the others can't come out mirrored. */
function symmetricPoints(character: Character): Int32Array {
  const { skeleton, skin, mesh } = character;
  const { partners, plane, reference } = symmetryOf(skeleton);
  const images = mirroredPoints(posedPoints(character, reference), plane, 1e-5);
  const row = (vertex: number, map: (joint: number) => number): string => {
    const point = mesh.pointOf[vertex]!;
    const entries = [];
    for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
      const joint = map(skin.paletteJoint[skin.entries[i]!]!);
      if (skin.weights[i]! > 0) entries.push(`${joint} ${skin.weights[i]!.toFixed(5)}`);
    }
    return entries.sort().join();
  };
  const same = images.map((image, vertex) =>
    image >= 0 && row(image, (joint) => joint) === row(vertex, (joint) => partners[joint]!)
      ? image
      : -1,
  );
  // A test of few points would show little.
  expect(same.filter((image) => image >= 0).length).toBeGreaterThan(0.8 * same.length);
  return same;
}

function largestOffset(figure: Float32Array, image: Float32Array, points: Int32Array): number {
  let largest = 0;
  points.forEach((other, vertex) => {
    if (other < 0) return;
    const [x, y, z] = [0, 1, 2].map((axis) => figure[vertex * 3 + axis]!);
    const there = [0, 1, 2].map((axis) => image[other * 3 + axis]!);
    largest = Math.max(largest, largestDifference([-x!, y!, z!], there));
  });
  return largest;
}

/** A body whose left and right limb stand mirrored, with frames and degrees of freedom of their own. */
function oddBody(left: readonly DofParts[], right: readonly DofParts[], seed: number): Skeleton {
  const random = randomSource(seed);
  const slides = axes.map((axis): DofParts => ({ kind: DofKind.slide, axis }));
  const body: JointParts = {
    name: 'body',
    parent: -1,
    restOffset: [0.2, 1, 0],
    dofs: [...slides, ...xyz],
  };
  const joints = [body];
  for (const [side, dofs, sign] of [
    ['L', left, 1],
    ['R', right, -1],
  ] as const) {
    let parent = 0;
    let characterFromParent = identity;
    for (const [index, step] of steps.entries()) {
      const restRotation = randomRotation(random, 2) as [number, number, number, number];
      const [x, y, z] = transform(transpose(characterFromParent), [
        step[0] * sign,
        step[1],
        step[2],
      ]);
      joints.push({
        name: `limb ${index} ${side}`,
        parent,
        restOffset: [x!, y!, z!],
        restRotation,
        dofs,
      });
      parent = joints.length - 1;
      characterFromParent = multiply(characterFromParent, rotationOf(restRotation));
    }
  }
  return buildSkeleton({ file: 'odd.skel', joints }, new DiagnosticLog('odd.skel'))!;
}

const axes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const;
const steps = [
  [0.3, 0.1, 0],
  [0.4, -0.2, 0.1],
  [0.2, -0.3, 0.2],
] as const;
const xyz = axes.map((axis): DofParts => ({ kind: DofKind.hinge, axis }));
const zyx = xyz.toReversed();
const ball: readonly DofParts[] = [{ kind: DofKind.ball, axis: [0, 0, 0] }];
const slideAfterBall: readonly DofParts[] = [...ball, { kind: DofKind.slide, axis: [0, 1, 0] }];
const movable: readonly DofParts[] = [
  ...axes.map((axis): DofParts => ({ kind: DofKind.slide, axis })),
  ...ball,
];

describe('joints whose frames at rest are no mirror images', () => {
  it.each([
    ['hinges XYZ and XYZ', xyz, xyz],
    ['hinges XYZ and ZYX', xyz, zyx],
    ['hinges ZYX and a ball', zyx, ball],
    ['two balls', ball, ball],
    ['slides with balls', movable, movable],
  ] as const)('are mirrored in space: %s', (_, left, right) => {
    for (let seed = 1; seed <= 12; seed++) {
      const skeleton = oddBody(left, right, seed);
      const q = randomPose(skeleton, seed, 1.3);
      const image = mirrored(skeleton, q);
      expectMirrored(skeleton, q, image);
      const again = jointMatrices(skeleton, mirrored(skeleton, image));
      expect(largestDifference(again, jointMatrices(skeleton, q))).toBeLessThan(tolerances.turn);
    }
  });

  it('says which joints can not take the whole rotation', () => {
    const skeleton = oddBody(xyz, xyz.slice(1), 1);
    const q = randomPose(skeleton, 1);
    const { stopped } = mirrorJoints(symmetryOf(skeleton), q, q, everyJoint(skeleton));
    expect(stopped.map((joint) => skeleton.names[joint])).toEqual([
      'limb 0 R',
      'limb 1 R',
      'limb 2 R',
    ]);
  });

  it('slide as they turn', () => {
    const skeleton = oddBody(slideAfterBall, movable, 3);
    const q = randomPose(skeleton, 3);
    const symmetry = symmetryOf(skeleton);
    const left = everyJoint(skeleton).filter((joint) => symmetry.sides[joint] === 1);
    const { q: image, stopped } = mirrorJoints(symmetry, q, skeleton.qRest, left);
    expect(stopped).toEqual([]);
    const still = skeleton.qRest.slice();
    const first = skeleton.dofQ[skeleton.dofStart[left[0]!]!]!;
    still.set(q.subarray(first, first + 15), first);
    expectMirrored(skeleton, still, image, left);
  });
});

/** The rotations since rest and the places of all joints are mirrored, by plain matrices. */
function expectMirrored(
  skeleton: Skeleton,
  q: Float64Array,
  image: Float64Array,
  joints = everyJoint(skeleton),
): void {
  const { partners, plane, reference } = symmetryOf(skeleton);
  const [rest, posed, other] = [reference, q, image].map((each) => jointMatrices(skeleton, each));
  for (const joint of joints) {
    const partner = partners[joint]!;
    const turned = sinceRest(posed!, rest!, joint);
    const expected = turned.map((row, r) =>
      row.map((value, c) => ((r === 0) === (c === 0) ? value : -value)),
    );
    const found = sinceRest(other!, rest!, partner);
    expect(largestDifference(found.flat(), expected.flat())).toBeLessThan(tolerances.turn);
    const at = (matrices: Float64Array, of: number) =>
      matrices.subarray(of * 16 + 12, of * 16 + 15);
    const [x, y, z] = at(posed!, joint);
    const image = [2 * plane - x!, y!, z!];
    expect(largestDifference(at(other!, partner), image)).toBeLessThan(tolerances.turn);
  }
}

/** The rotation of a joint since rest, in the character's space, by rows. */
function sinceRest(posed: Float64Array, rest: Float64Array, joint: number): Matrix {
  const rowsOf = (all: Float64Array): Matrix =>
    [0, 1, 2].map((r) => [0, 1, 2].map((c) => all[joint * 16 + c * 4 + r]!));
  return multiply(rowsOf(posed), transpose(rowsOf(rest)));
}

describe('limits that are no mirror images', () => {
  it('stop the partner, and it is said', async () => {
    const { skeleton } = await bundled('insect');
    const [left, right] = ['wing_l', 'wing_r'].map((name) => skeleton.names.indexOf(name));
    const qMin = skeleton.qMin.slice();
    const at = skeleton.dofQ[skeleton.dofStart[right!]!]!;
    qMin[at] = -0.5;
    const narrow = { ...skeleton, qMin };
    const q = skeleton.qRest.slice();
    q[skeleton.dofQ[skeleton.dofStart[left!]!]!] = 1.1;
    const { q: image, stopped } = mirrorJoints(symmetryOf(narrow), q, q, [left!]);
    expect(image[at]).toBe(-0.5);
    expect(stopped).toEqual([right]);
  });
});
