import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import { jointRange, type Pose } from '../../src/core/pose.ts';
import { sameValue } from '../../src/core/same-value.ts';
import { subtreeEnd } from '../../src/core/subtree.ts';
import { blendPoses } from '../../src/posing/blend-poses.ts';
import { fitPose } from '../../src/posing/fit-pose.ts';
import { dofLetters, namePose } from '../../src/posing/named-pose.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { forest, rotatedTree } from '../fixtures/rigs.ts';
import {
  type Matrix,
  multiply,
  rotationAbout,
  rotationOf as ofQuaternion,
  transpose,
} from '../reference/matrix.ts';
import { withMorph } from '../fixtures/with-morph.ts';
import { leg } from '../support/cse169-files.ts';
import { readOne } from '../support/files.ts';
import { tolerances } from '../tolerances.ts';

const tree = characterOfRig(rotatedTree());
const balls = characterOfRig(forest());
const limited = await readOne(leg);

const allJoints = ({ skeleton }: Character): number[] =>
  Array.from({ length: skeleton.jointCount }, (_, joint) => joint);

const restOf = ({ skeleton, morphs }: Character): Required<Pose> => ({
  q: skeleton.qRest.slice(),
  morphWeights: new Float64Array(morphs.length),
});

/** Poses within the limits, with unit quaternions. */
function poseOf(character: Character): fc.Arbitrary<Required<Pose>> {
  const { skeleton, morphs } = character;
  const { qRest, qMin, qMax } = skeleton;
  const list = (length: number) =>
    fc.array(fc.double({ min: -3, max: 3, noNaN: true }), { minLength: length, maxLength: length });
  return fc.tuple(list(qRest.length), list(morphs.length)).map(([values, weights]) => {
    const q = Float64Array.from(values, (value, i) =>
      Math.min(Math.max(value, qMin[i]!), qMax[i]!),
    );
    for (const joint of allJoints(character)) {
      const [, to] = jointRange(skeleton, joint);
      if (dofLetters(skeleton, joint).endsWith('Q')) q.set(unit(q.subarray(to - 4, to)), to - 4);
    }
    return { q, morphWeights: Float64Array.from(weights) };
  });
}

function unit(values: Float64Array): number[] {
  const length = Math.hypot(...values);
  return length < 1e-3 ? [0, 0, 0, 1] : [...values].map((value) => value / length);
}

/** The rotation of a joint's hinges or ball, by the oracle's matrices. */
function rotationOf({ skeleton }: Character, joint: number, q: Float64Array): Matrix {
  const letters = dofLetters(skeleton, joint);
  let [at] = jointRange(skeleton, joint);
  let rotation: Matrix | undefined;
  for (const letter of letters) {
    const axis = 'XYZ'.indexOf(letter);
    const own =
      letter === 'Q'
        ? ofQuaternion([...q.subarray(at, at + 4)])
        : axis < 0
          ? undefined
          : rotationAbout(
              [0, 1, 2].map((each) => (each === axis ? 1 : 0)),
              q[at]!,
            );
    if (own) rotation = rotation ? multiply(rotation, own) : own;
    at += letter === 'Q' ? 4 : 1;
  }
  return rotation!;
}

/** The angle between two rotations, from 0 to π, exact near 0 as well. */
function angleBetween(a: Matrix, b: Matrix): number {
  const turn = multiply(transpose(a), b);
  const m = (row: number, column: number): number => turn[row]![column]!;
  const sine = Math.hypot(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)) / 2;
  return Math.atan2(sine, (m(0, 0) + m(1, 1) + m(2, 2) - 1) / 2);
}

describe('a pose by name', () => {
  it('of the whole character brings back every bit, whatever was shown', () => {
    for (const character of [tree, balls, limited, withMorph(tree)]) {
      fc.assert(
        fc.property(poseOf(character), poseOf(character), (pose, shown) => {
          const named = namePose(character, pose, allJoints(character));
          const fitted = fitPose(character, shown, named);
          expect(sameValue(fitted.pose, pose)).toBe(true);
          expect([fitted.missing, fitted.partly]).toEqual([[], []]);
        }),
        { numRuns: 20 },
      );
    }
  });

  it('of a part leaves the bits of all other joints and of the shape', () => {
    const character = tree;
    const { skeleton } = character;
    fc.assert(
      fc.property(
        poseOf(character),
        poseOf(character),
        fc.nat(skeleton.jointCount - 1),
        (pose, shown, joint) => {
          const branch = allJoints(character).slice(joint, subtreeEnd(skeleton, joint));
          const { pose: result, joints } = fitPose(
            character,
            shown,
            namePose(character, pose, branch),
          );
          for (const each of allJoints(character)) {
            const [from, to] = jointRange(skeleton, each);
            const source = branch.includes(each) ? pose : shown;
            expect(sameValue(result.q.subarray(from, to), source.q.subarray(from, to))).toBe(true);
          }
          expect(sameValue(result.morphWeights, shown.morphWeights)).toBe(true);
          // The joint that nothing can move is in no pose.
          expect(joints).toEqual(branch.filter((each) => dofLetters(skeleton, each) !== ''));
        },
      ),
      { numRuns: 40 },
    );
  });

  it('turns a joint of other degrees of freedom in the same way, and says what did not fit', () => {
    const named = {
      height: 0,
      joints: [
        { name: 'joint 0', dofs: 'Q', values: unit(Float64Array.of(0.3, -0.5, 0.2, 0.7)) },
        { name: 'JOINT 2', dofs: 'XYZ', values: [0.4, 0.8, -0.3] },
        { name: 'joint 1', dofs: 'ZYX', values: [1, 0.2, 0.1] },
        { name: 'joint 7', dofs: 'XYZ', values: [0.5, 0, 0.25] },
        { name: 'tail', dofs: 'X', values: [1] },
      ],
      morphs: [{ name: 'smile', weight: 1 }],
    };
    const { pose, missing, partly } = fitPose(tree, restOf(tree), named);
    expect(missing).toEqual(['tail', 'smile']);
    expect(partly).toEqual(['joint 7']); // which only turns about z
    for (const { name, dofs, values } of named.joints.slice(0, 3)) {
      const joint = tree.skeleton.names.indexOf(name.toLowerCase());
      const wanted =
        dofs === 'Q'
          ? ofQuaternion(values)
          : Array.from(dofs)
              .map((letter, i) =>
                rotationAbout(
                  [0, 1, 2].map((axis) => ('XYZ'[axis] === letter ? 1 : 0)),
                  values[i]!,
                ),
              )
              .reduce(multiply);
      const found = rotationOf(tree, joint, pose.q);
      expect(angleBetween(found, wanted), name).toBeLessThan(tolerances.turn);
    }
    const joint7 = jointRange(tree.skeleton, tree.skeleton.names.indexOf('joint 7'))[0];
    expect(pose.q[joint7]).toBe(0.25);
  });

  it('is clamped to the limits of a joint, which is said, and slides in its own size', () => {
    const { skeleton } = limited;
    const first = allJoints(limited).find(
      (joint) => skeleton.qMax[jointRange(skeleton, joint)[0]]! < 9,
    )!;
    const [from] = jointRange(skeleton, first);
    const named = namePose(limited, restOf(limited), [first]);
    const values = [...named.joints[0]!.values];
    values[0] = 10;
    const far = { ...named, joints: [{ ...named.joints[0]!, values }] };
    const { pose, partly } = fitPose(limited, restOf(limited), far);
    expect(pose.q[from]).toBe(skeleton.qMax[from]);
    expect(partly).toEqual([skeleton.names[first]]);

    const root = allJoints(tree).find((joint) =>
      dofLetters(tree.skeleton, joint).startsWith('xyz'),
    )!;
    const moved = restOf(tree);
    const [at] = jointRange(tree.skeleton, root);
    moved.q.set([1, 2, 3], at);
    const small = namePose(tree, moved, [root]);
    const doubled = fitPose(tree, restOf(tree), { ...small, height: small.height / 2 });
    expect([...doubled.pose.q.subarray(at, at + 3)]).toEqual([2, 4, 6]);
    expect(doubled.partly).toEqual([]);
  });
});

describe('blending one pose into another', () => {
  it('has the bits of the first at 0 and of the second at 1, and at every step those of joints that stay', () => {
    fc.assert(
      fc.property(
        poseOf(tree),
        poseOf(tree),
        fc.nat(tree.skeleton.jointCount - 1),
        fc.double({ min: 0, max: 1, noNaN: true }),
        (from, other, joint, fraction) => {
          const to = { ...from, q: from.q.slice() };
          const [start, end] = jointRange(tree.skeleton, joint);
          to.q.set(other.q.subarray(start, end), start);
          expect(sameValue(blendPoses(tree.skeleton, from, to, 0), from)).toBe(true);
          expect(sameValue(blendPoses(tree.skeleton, from, to, 1), to)).toBe(true);
          const { q } = blendPoses(tree.skeleton, from, to, fraction);
          expect(sameValue(q.subarray(0, start), from.q.subarray(0, start))).toBe(true);
          expect(sameValue(q.subarray(end), from.q.subarray(end))).toBe(true);
        },
      ),
      { numRuns: 60 },
    );
  });

  it.each([
    ['hinges and balls', tree],
    ['balls', balls],
  ])('turns %s by a part of the whole angle that is the fraction', (_, character) => {
    const { skeleton } = character;
    const turning = allJoints(character).filter((joint) =>
      /(Q|XYZ|ZYX)$/.test(dofLetters(skeleton, joint)),
    );
    expect(turning.length).toBeGreaterThan(2);
    fc.assert(
      fc.property(
        poseOf(character),
        poseOf(character),
        fc.constantFrom(...turning),
        fc.double({ min: 0, max: 1, noNaN: true }),
        (from, to, joint, fraction) => {
          const [a, b] = [from, to].map(({ q }) => rotationOf(character, joint, q));
          const { q } = blendPoses(skeleton, from, to, fraction);
          const middle = rotationOf(character, joint, q);
          const whole = angleBetween(a!, b!);
          fc.pre(whole < Math.PI - 1e-3); // beyond, either way round is the shorter one
          expect(Math.abs(angleBetween(a!, middle) - fraction * whole)).toBeLessThan(1e-7);
          expect(Math.abs(angleBetween(middle, b!) - (1 - fraction) * whole)).toBeLessThan(1e-7);
        },
      ),
      { numRuns: 200 },
    );
  });

  it('never passes the limits of a character that has some', () => {
    const { skeleton } = limited;
    expect([...skeleton.qMax].some(Number.isFinite)).toBe(true);
    fc.assert(
      fc.property(
        poseOf(limited),
        poseOf(limited),
        fc.double({ min: 0, max: 1, noNaN: true }),
        (from, to, fraction) => {
          blendPoses(skeleton, from, to, fraction).q.forEach((value, i) => {
            expect(value).toBeGreaterThanOrEqual(skeleton.qMin[i]!);
            expect(value).toBeLessThanOrEqual(skeleton.qMax[i]!);
          });
        },
      ),
      { numRuns: 60 },
    );
  });
});
