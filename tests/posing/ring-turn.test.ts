import { quat, vec3 } from 'gl-matrix';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { parentMatrix } from '../../src/posing/joint-frames.ts';
import { type JointRing, jointRings } from '../../src/posing/joint-rings.ts';
import { ringTurn, seenRing, snappedTurn, turnRing } from '../../src/posing/ring-turn.ts';
import { transform, unit } from '../reference/matrix.ts';
import { largestDifference } from '../support/compare.ts';
import { randomSource, randomUnitVector } from '../support/random.ts';
import { tolerances } from '../tolerances.ts';
import { dot, dragRig, type DragRig, TestView, worldOf } from './drag-rigs.ts';

const seeds = fc.nat(1e6);
const angle = fc.double({ min: -3, max: 3, noNaN: true });
const pixel = fc.double({ min: -300, max: 300, noNaN: true });
const kinds = ['x', 'y', 'xy', 'zx', 'xyz', 'zyx', 'sxyz', 'zxy', 'xsx', 'b', 'sb'];
const limb = [0.1, 0.4, -0.2] as const;
/** Small beside the viewer's distance of three units, so that a ring is seen as an ellipse. */
const radius = 0.002;

function ringsOf({ skeleton, joint }: DragRig, q: Float64Array): JointRing[] {
  return jointRings(skeleton, joint, q, parentMatrix(skeleton, joint, q), limb);
}

function placeOf({ center, mark, normal }: JointRing) {
  const first = vec3.scale(new Float64Array(3), mark, radius);
  return { center, first, second: vec3.cross(new Float64Array(3), normal, first) };
}

function seenFrom(view: TestView, ring: JointRing) {
  return seenRing(placeOf(ring), view.eye, (at) => view.pixelsOf(at));
}

/** The pose with one ring turned, computed without the code under test. */
function turnedBy(q: Float64Array, { index, ballAxis }: JointRing, turn: number): Float64Array {
  const next = q.slice();
  if (ballAxis === undefined) next[index]! += turn;
  else {
    // A quaternion times that of a turn about x, y or z.
    const [x, y, z, w] = q.subarray(index, index + 4) as unknown as [
      number,
      number,
      number,
      number,
    ];
    const [s, c] = [Math.sin(turn / 2), Math.cos(turn / 2)];
    const products = [
      [x * c + w * s, y * c + z * s, z * c - y * s, w * c - x * s],
      [x * c - z * s, y * c + w * s, z * c + x * s, w * c - y * s],
      [x * c + y * s, y * c - x * s, z * c + w * s, w * c - z * s],
    ];
    next.set(products[ballAxis]!, index);
  }
  return next;
}

describe.each(kinds)('the rings of a joint of kind "%s"', (kind) => {
  it('are about the axes that its values turn it about, counterclockwise', () => {
    fc.assert(
      fc.property(seeds, (seed) => {
        const rig = dragRig(kind, seed);
        for (const ring of ringsOf(rig, rig.q)) {
          // A point of the joint moves along normal × arm when the value grows.
          const step = 1e-6;
          const [before, after] = [-step, step].map((turn) =>
            transform(worldOf(rig, turnedBy(rig.q, ring, turn)), limb),
          );
          const motion = after!.map((value, i) => (value - before![i]!) / (2 * step));
          const arm = transform(worldOf(rig, rig.q), limb).map(
            (value, i) => value - ring.center[i]!,
          );
          const [n, a] = [ring.normal, arm];
          expect(
            largestDifference(motion, [
              n[1] * a[2]! - n[2] * a[1]!,
              n[2] * a[0]! - n[0] * a[2]!,
              n[0] * a[1]! - n[1] * a[0]!,
            ]),
          ).toBeLessThan(1e-8);
          expect(Math.abs(vec3.length(ring.normal) - 1)).toBeLessThan(tolerances.turn);
          expect(Math.abs(dot(ring.mark, ring.normal))).toBeLessThan(tolerances.turn);
        }
      }),
      { numRuns: 50 },
    );
  });

  it('carry a mark that turns by the angle of the value', () => {
    fc.assert(
      fc.property(seeds, angle, (seed, turn) => {
        const rig = dragRig(kind, seed);
        ringsOf(rig, rig.q).forEach((ring, i) => {
          const after = ringsOf(rig, turnedBy(rig.q, ring, turn))[i]!;
          const sine = dot(vec3.cross(new Float64Array(3), ring.mark, after.mark), ring.normal);
          const seen = Math.atan2(sine, dot(ring.mark, after.mark));
          expect(Math.abs(Math.sin((seen - turn) / 2))).toBeLessThan(1e-7);
        });
      }),
      { numRuns: 50 },
    );
  });

  it('turn by an angle when the pointer carries a point of the ring by this angle', () => {
    fc.assert(
      fc.property(seeds, seeds, angle, (seed, viewSeed, turn) => {
        const rig = dragRig(kind, seed);
        for (const ring of ringsOf(rig, rig.q)) {
          const away = randomUnitVector(randomSource(viewSeed));
          const view = new TestView([...ring.center], away);
          if (Math.abs(dot(ring.normal, away)) < 0.3) continue; // nearly edge-on
          const seen = seenFrom(view, ring);
          // The point is fixed to what the ring turns; the oracle moves it.
          const held = placeOf(ring);
          const moved = [...held.center].map(
            (value, i) =>
              value + Math.cos(turn) * held.first[i]! + Math.sin(turn) * held.second[i]!,
          );
          const from = view.pixelsOf([...held.center].map((value, i) => value + held.first[i]!));
          const found = ringTurn(seen, from, view.pixelsOf(moved), turn);
          expect(Math.abs(found - turn)).toBeLessThan(0.01);
          // The pose is that in which the joint has turned so.
          const q = turnRing(rig.skeleton, rig.q, ring, found);
          const place = transform(worldOf(rig, q), limb);
          const expected = transform(worldOf(rig, turnedBy(rig.q, ring, turn)), limb);
          expect(largestDifference(place, expected)).toBeLessThan(0.01);
        }
      }),
      { numRuns: 50 },
    );
  });

  it('change only their own value, and keep its limits', () => {
    fc.assert(
      fc.property(seeds, angle, (seed, turn) => {
        const rig = dragRig(kind, seed, [-0.5, 0.8]);
        const { skeleton, q } = rig;
        for (const ring of ringsOf(rig, q)) {
          const next = turnRing(skeleton, q, ring, turn);
          const size = ring.ballAxis === undefined ? 1 : 4;
          const changed = [...next.keys()].filter((i) => next[i] !== q[i]);
          expect(changed.every((i) => i >= ring.index && i < ring.index + size)).toBe(true);
          if (size === 4) {
            expect(Math.abs(quat.length(next.slice(ring.index, ring.index + 4)) - 1)).toBeLessThan(
              tolerances.turn,
            );
            continue;
          }
          expect(ring.range[0]).toBeCloseTo(-0.5, 9);
          expect(ring.range[1]).toBeCloseTo(0.8, 9);
          const wanted = q[ring.index]! + Math.min(0.8, Math.max(-0.5, turn));
          expect(next[ring.index]!).toBeCloseTo(wanted, 9);
          expect(next[ring.index]!).toBeGreaterThanOrEqual(skeleton.qMin[ring.index]!);
          expect(next[ring.index]!).toBeLessThanOrEqual(skeleton.qMax[ring.index]!);
        }
      }),
      { numRuns: 50 },
    );
  });
});

it('a locked hinge and slides have no ring', () => {
  expect(ringsOf(dragRig('s', 1), dragRig('s', 1).q)).toEqual([]);
  const locked = dragRig('xyz', 1, [0, 0]);
  expect(ringsOf(locked, locked.q)).toEqual([]);
});

it('a ring seen edge-on rolls with its near side, by its radius in pixels for a radian', () => {
  fc.assert(
    fc.property(
      seeds,
      pixel,
      fc.double({ min: -0.15, max: 0.15, noNaN: true }),
      (seed, right, tilt) => {
        const rig = dragRig('z', seed);
        const [ring] = ringsOf(rig, rig.q);
        // The viewer is in the ring's plane, or nearly so.
        const away = unit([0, 1, 2].map((i) => ring!.mark[i]! + tilt * ring!.normal[i]!));
        const view = new TestView([...ring!.center], away);
        const seen = seenFrom(view, ring!);
        const along = vec3.cross(new Float64Array(3), ring!.normal, ring!.mark);
        const [x, y] = [dot(along, view.right), dot(along, view.up)];
        const turn = ringTurn(seen, [3, 4], [3 + right * x, 4 + right * y]);
        const size = Math.hypot(...seen.first, ...seen.second);
        expect(Math.abs(turn * size - right)).toBeLessThan(0.03 * Math.abs(right) + 1e-9);
      },
    ),
  );
});

it('a pointer that goes around counts full turns, and back at the start nothing is changed', () => {
  fc.assert(
    fc.property(seeds, fc.integer({ min: -3, max: 3 }), (seed, rounds) => {
      const rig = dragRig('xyz', seed);
      const [ring] = ringsOf(rig, rig.q);
      const view = new TestView([...ring!.center], [...ring!.normal]);
      const seen = seenFrom(view, ring!);
      const at = (turn: number) => [40 * Math.cos(turn), 40 * Math.sin(turn)] as const;
      let turn = 0;
      const steps = 16 * Math.abs(rounds);
      for (let step = 1; step <= steps; step++) {
        turn = ringTurn(seen, at(0), at((Math.sign(rounds) * step * Math.PI) / 8), turn);
      }
      expect(Math.abs(turn)).toBeCloseTo(Math.abs(rounds) * 2 * Math.PI, 6);
      expect(turnRing(rig.skeleton, rig.q, ring!, ringTurn(seen, at(1), at(1)))).toEqual(rig.q);
    }),
  );
});

it('snapping gives a hinge a multiple of the step, and turns a ball by one', () => {
  const step = Math.PI / 12;
  const hinge = dragRig('x', 5);
  const [ring] = ringsOf(hinge, hinge.q);
  const { index } = ring!;
  const snapped = snappedTurn(hinge.q[index]!, 0.4, step);
  const value = turnRing(hinge.skeleton, hinge.q, ring!, snapped)[index]! / step;
  expect(Math.abs(snapped - 0.4)).toBeLessThanOrEqual(step / 2);
  expect(Math.abs(value - Math.round(value))).toBeLessThan(tolerances.turn);
  const ball = dragRig('b', 5);
  const [, about] = ringsOf(ball, ball.q);
  const turned = turnRing(ball.skeleton, ball.q, about!, snappedTurn(null, 0.4, step));
  expect(largestDifference(turned, turnedBy(ball.q, about!, 2 * step))).toBeLessThan(
    tolerances.turn,
  );
});
