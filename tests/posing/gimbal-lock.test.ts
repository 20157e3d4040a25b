import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { gimbalLock } from '../../src/posing/gimbal-lock.ts';
import { type Matrix, multiply, rotationAbout, transform } from '../reference/matrix.ts';
import { dot, dragRig } from './drag-rigs.ts';

const axes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const;
const degree = Math.PI / 180;
const turns = fc.integer({ min: -2, max: 2 });
const any = fc.double({ min: -3, max: 3, noNaN: true });

/** The angle between the lines of the outer and the inner axis, from the product itself. */
function angleBetween(order: string, angles: readonly number[]): number {
  const [outer, middle, inner] = Array.from(order) as (keyof typeof axes)[];
  const before: Matrix = multiply(
    rotationAbout(axes[outer!], angles[0]!),
    rotationAbout(axes[middle!], angles[1]!),
  );
  const innerAxis = transform(before, axes[inner!], 0);
  return Math.acos(Math.min(1, Math.abs(dot(axes[outer!], innerAxis))));
}

describe.each(['xyz', 'zyx', 'zxy'])('R = %s', (order) => {
  it('is locked where its outer and inner axes are within 5° of one line, and nowhere else', () => {
    const { skeleton, q, joint } = dragRig(order, 1);
    const from = skeleton.dofQ[skeleton.dofStart[joint]!]!;
    const middles = fc.oneof(
      any,
      fc.tuple(turns, fc.constantFrom(-90, 90), fc.double({ min: -7, max: 7, noNaN: true })),
    );
    let locked = 0;
    fc.assert(
      fc.property(any, middles, any, (first, middle, last) => {
        const angle =
          typeof middle === 'number' ? middle : (360 * middle[0] + middle[1] + middle[2]) * degree;
        const between = angleBetween(order, [first, angle, last]);
        // The rounding of the two sides may differ at the boundary itself.
        fc.pre(Math.abs(between - 5 * degree) > 1e-6);
        const posed = q.slice();
        posed.set([first, angle, last], from);
        const expected = between < 5 * degree ? [from, from + 2] : null;
        if (expected) locked++;
        expect(gimbalLock(skeleton, joint, posed)).toEqual(expected);
      }),
    );
    expect(locked).toBeGreaterThan(5);
  });
});

it('only three free hinges lock: no ball, no pair, and none whose limits are equal', () => {
  for (const kind of ['b', 'xy', 'x', 's', 'sb']) {
    const { skeleton, q, joint } = dragRig(kind, 2);
    expect(gimbalLock(skeleton, joint, q.fill(Math.PI / 2))).toBeNull();
  }
  const { skeleton, joint } = dragRig('xyz', 3, [0, 0]);
  expect(gimbalLock(skeleton, joint, skeleton.qRest.slice().fill(Math.PI / 2))).toBeNull();
});
