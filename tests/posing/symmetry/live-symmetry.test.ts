import { expect, it } from 'vitest';
import { jointRange } from '../../../src/core/pose.ts';
import type { Skeleton } from '../../../src/core/skeleton.ts';
import { liveSymmetry } from '../../../src/posing/symmetry/live-symmetry.ts';
import { mirrorJoints, symmetryOf } from '../../../src/posing/symmetry/symmetry.ts';
import { bundled, randomPose } from './mirror-laws.ts';

/** A pose with some joints as they are in another one. */
function withJoints(
  skeleton: Skeleton,
  onto: Float64Array,
  from: Float64Array,
  names: readonly string[],
): Float64Array {
  const q = onto.slice();
  for (const name of names) {
    const [start, end] = jointRange(skeleton, skeleton.names.indexOf(name));
    q.set(from.subarray(start, end), start);
  }
  return q;
}

it('is the mirror of the one side, whichever it is, and leaves the plane free', async () => {
  const { skeleton } = await bundled('human');
  const symmetry = symmetryOf(skeleton);
  const base = randomPose(skeleton, 1);
  const other = randomPose(skeleton, 2);
  const changed = ['Left forearm', 'Right upper leg', 'Chest'];
  const edited = withJoints(skeleton, base, other, changed);
  const sided = changed.slice(0, 2).map((name) => skeleton.names.indexOf(name));
  const expected = mirrorJoints(symmetry, edited, edited, sided).q;
  expect(liveSymmetry(symmetry, base)(edited)).toEqual(expected);
  expect(expected).not.toEqual(edited);
});

it('takes edits of the start and of what is shown, and goes all the way back', async () => {
  const { skeleton } = await bundled('human');
  const symmetry = symmetryOf(skeleton);
  const base = randomPose(skeleton, 1);
  const names = ['Left forearm'];
  const ends = [3, 4].map((seed) => withJoints(skeleton, base, randomPose(skeleton, seed), names));
  const fromStart = liveSymmetry(symmetry, base);
  const fromShown = liveSymmetry(symmetry, base);
  let shown = base;
  for (const end of [...ends, ends[1]!, ends[0]!]) {
    shown = fromShown(withJoints(skeleton, shown, end, names));
    expect(fromStart(end)).toEqual(shown);
  }
  expect(fromStart(base)).toEqual(base);
  expect(fromShown(withJoints(skeleton, shown, base, names))).toEqual(base);
});

it('keeps a pair that is changed on both sides, unless both lead', async () => {
  const { skeleton } = await bundled('human');
  const symmetry = symmetryOf(skeleton);
  const [base, other] = [randomPose(skeleton, 1), randomPose(skeleton, 2)];
  const names = ['Left forearm', 'Right forearm'];
  const [left, right] = names.map((name) => skeleton.names.indexOf(name));
  const edited = withJoints(skeleton, base, other, names);
  expect(liveSymmetry(symmetry, base)(edited)).toEqual(edited);
  const led = liveSymmetry(symmetry, base, [right!, left!]);
  const expected = mirrorJoints(symmetry, edited, edited, [right!]).q;
  expect(led(edited)).toEqual(expected);
  expect(led(edited)).toEqual(expected);
});
