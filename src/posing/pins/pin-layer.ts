import { forwardKinematics } from '../../core/forward-kinematics.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import { dls } from '../ik/dls.ts';
import type { IkGoal } from '../ik/problem.ts';
import type { LayerFunction } from '../pose-layer.ts';
import { freedJoints } from './freed-joints.ts';
import { jointRotation, pinnedPoint, pinTarget } from './pin-target.ts';

/** Pins are held to this part of their limb's length, and to ten times as many radians. */
const tolerance = 1e-4;
/** A pose that does not lower the error by this part is no better, so that the end is a fixed point. */
const leastGain = 0.02;
const mostRounds = 8;

/**
 * Moves joints so that all pins hold. It begins with the limbs, and frees more of the body only if
 * they can't reach. It is a function of its arguments alone, and its result is a fixed point: applied
 * to it, the layer changes no bit. That is so because each round is a function of the pose, and the
 * last one has found nothing better.
 */
export const applyPins: LayerFunction = ({ character, pins, followed }, q) => {
  const { skeleton } = character;
  const goals = pins.flatMap((pin, at): IkGoal[] => {
    if (pin.weight === 0) return [];
    const { place, rotation } = pinTarget(pin, followed, at);
    const { joint, point, weight } = pin;
    return [{ joint, point, target: place, weight, ...(rotation && { rotation }) }];
  });
  if (goals.length === 0) return;
  const sets = freedJoints(
    skeleton,
    pins.filter(({ weight }) => weight > 0),
  );
  const measure = new Measure(skeleton, goals);
  let error = measure.of(q);
  for (let round = 0; round < mostRounds; round++) {
    const before = error;
    for (const [size, joints] of sets.entries()) {
      if (error.isHeld) return;
      const hasRoot = size === sets.length - 1;
      const problem = { skeleton, goals, joints, reference: q, natures: [] };
      // Where a root may slide without limits, everything is within reach, and other starts are vain.
      const solved = dls.solve(problem, { restarts: hasRoot ? 0 : 4, tolerance: tolerance / 2 });
      const found = measure.of(solved.q);
      if (found.cost > error.cost * (1 - leastGain)) continue;
      q.set(solved.q);
      error = found;
    }
    if (error === before) return;
  }
};

interface PinError {
  /** The weighted sum of squared errors, in lengths of the limbs. */
  readonly cost: number;
  /** Whether every pin holds. */
  readonly isHeld: boolean;
}

/** Measures how far a pose is from holding its pins. */
class Measure {
  readonly #skeleton: Skeleton;
  readonly #goals: readonly IkGoal[];
  readonly #lengths: readonly number[];
  readonly #characterFromJoint: Float64Array;

  constructor(skeleton: Skeleton, goals: readonly IkGoal[]) {
    this.#skeleton = skeleton;
    this.#goals = goals;
    this.#lengths = goals.map(({ joint }) => pathLength(skeleton, joint));
    this.#characterFromJoint = new Float64Array(skeleton.jointCount * 16);
  }

  of(q: Float64Array): PinError {
    const matrices = this.#characterFromJoint;
    forwardKinematics(this.#skeleton, q, matrices);
    let cost = 0;
    let isHeld = true;
    for (const [at, { joint, point, target, rotation, weight }] of this.#goals.entries()) {
      const [x, y, z] = pinnedPoint({ joint, point }, matrices);
      const distance = Math.hypot(x - target[0], y - target[1], z - target[2]) / this.#lengths[at]!;
      const turn = rotation ? angleBetween(jointRotation(joint, matrices), rotation) / 10 : 0;
      cost += weight * (distance ** 2 + turn ** 2);
      if (distance > tolerance || turn > tolerance) isHeld = false;
    }
    return { cost, isHeld };
  }
}

/** The length of the links from the root to a joint, without that to the root; at least a little. */
function pathLength({ parents, restOffsets }: Skeleton, joint: number): number {
  let length = 0;
  for (let each = joint; parents[each]! >= 0; each = parents[each]!) {
    length += Math.hypot(...restOffsets.subarray(each * 3, each * 3 + 3));
  }
  return length || 1;
}

/** In radians; accurate for small angles too. */
function angleBetween(a: readonly number[], b: readonly number[]): number {
  const dot = a.reduce((sum, value, i) => sum + value * b[i]!, 0);
  const sign = dot < 0 ? -1 : 1;
  return 4 * Math.asin(Math.min(1, Math.hypot(...a.map((value, i) => value - sign * b[i]!)) / 2));
}
