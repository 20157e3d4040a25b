import { forwardKinematics } from '../../core/forward-kinematics.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import { dls } from '../ik/dls.ts';
import type { IkGoal, IkOptions, IkSolver } from '../ik/problem.ts';
import { natural } from '../natural/natural-solver.ts';
import { naturesInUse } from '../natural/natures-in-use.ts';
import type { LayerFunction } from '../pose-layer.ts';
import { type Freed, freedJoints } from './freed-joints.ts';
import { pathLength } from './pin-miss.ts';
import { jointRotation, pinnedPoint, pinTarget } from './pin-target.ts';

/** Pins are held to this part of their limb's length, and to ten times as many radians. */
const tolerance = 1e-4;
/** A pose that does not lower the error by this part is no better, so that the end is a fixed point. */
const leastGain = 0.1;
const mostRounds = 8;

/** Keeps knees and elbows to how they bend by nature, at a cost that only a limb is worth. */
const careful = natural(dls);

/**
 * Moves joints so that all pins hold. It begins with the limbs, and frees more of the body only if
 * they can't reach. It is a function of its arguments alone, and its result is a fixed point: applied
 * to it, the layer changes no bit. That is so because each round is a function of the pose, and the
 * last one has found nothing better.
 */
export const applyPins: LayerFunction = ({ character, pins, natures: settings, followed }, q) => {
  const { skeleton } = character;
  const goals = pins.flatMap((pin, at): IkGoal[] => {
    if (pin.weight === 0) return [];
    const { place, rotation } = pinTarget(pin, followed, at);
    const { joint, point, weight } = pin;
    return [{ joint, point, target: place, weight, ...(rotation && { rotation }) }];
  });
  if (goals.length === 0) return;
  const { limbs, bodies } = freedJoints(
    skeleton,
    pins.filter(({ weight }) => weight > 0),
  );
  const natures = naturesInUse(character, settings);
  const measure = new Measure(skeleton, goals);
  let error = measure.of(q);
  const tryTo = (solver: IkSolver, freed: Freed, options: IkOptions): void => {
    if (freed.pins.every((pin) => error.holds[pin])) return;
    const own = freed.pins.map((pin) => goals[pin]!);
    const problem = { skeleton, goals: own, joints: freed.joints, reference: q, natures };
    const solved = solver.solve(problem, { ...options, tolerance: tolerance / 2 });
    const found = measure.of(solved.q);
    if (found.cost > error.cost * (1 - leastGain)) return;
    q.set(solved.q);
    error = found;
  };
  for (let round = 0; round < mostRounds; round++) {
    const before = error;
    for (const limb of limbs) tryTo(careful, limb, { restarts: 1, iterations: 30 });
    for (const body of bodies) tryTo(dls, body, { restarts: 0, iterations: 20 });
    if (error === before) return;
  }
};

interface PinError {
  /** The weighted sum of squared errors, in lengths of the limbs. */
  readonly cost: number;
  /** Whether each pin holds. */
  readonly holds: readonly boolean[];
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
    const holds: boolean[] = [];
    for (const [at, { joint, point, target, rotation, weight }] of this.#goals.entries()) {
      const [x, y, z] = pinnedPoint({ joint, point }, matrices);
      const distance = Math.hypot(x - target[0], y - target[1], z - target[2]) / this.#lengths[at]!;
      const turn = rotation ? angleBetween(jointRotation(joint, matrices), rotation) / 10 : 0;
      cost += weight * (distance ** 2 + turn ** 2);
      holds.push(distance <= tolerance && turn <= tolerance);
    }
    return { cost, holds };
  }
}

/** In radians; accurate for small angles too. */
function angleBetween(a: readonly number[], b: readonly number[]): number {
  const dot = a.reduce((sum, value, i) => sum + value * b[i]!, 0);
  const sign = dot < 0 ? -1 : 1;
  return 4 * Math.asin(Math.min(1, Math.hypot(...a.map((value, i) => value - sign * b[i]!)) / 2));
}
