import { forwardKinematics } from '../../core/forward-kinematics.ts';
import { noParent, type Skeleton } from '../../core/skeleton.ts';
import { dls, plainDls } from '../ik/dls.ts';
import type { IkGoal, JointNature } from '../ik/problem.ts';
import { naturesInUse } from '../natural/natures-in-use.ts';
import type { LayerFunction, PoseContext } from '../pose-layer.ts';
import { type Freed, freedJoints } from './freed-joints.ts';
import { pathLength } from './pin-miss.ts';
import { jointRotation, pinnedPoint, pinTarget } from './pin-target.ts';

/** Pins are held to this part of their limb's length, and to ten times as many radians. */
const tolerance = 1e-4;
/** A pose whose error a few steps do not lower by this part is left as it is. */
const leastGain = 0.1;
const fewSteps = 3;
/** What is stretched converges slowly, and only what has converged does not shake. */
const mostSteps = { limb: 80, body: 100 } as const;
const mostRounds = 8;
/** How much more than an elbow the roots resist, unless they have a nature: the body bends first. */
const rootStiffness = 10;

/** Moves joints so that all pins hold; see `holdPins`. */
export const applyPins: LayerFunction = (context, { q, pins }) => {
  holdPins({ ...context, pins }, q);
};

/**
 * Moves joints so that all pins hold. It begins with the limbs, which keep to how they bend by
 * nature, and frees the body if they can't reach. Nothing starts from elsewhere, and each solve is a
 * minimum that moves smoothly with its targets, so that nothing jumps in a drag.
 *
 * It is a function of its arguments alone, and its result is a fixed point: applied to it, it changes
 * no bit. That is so because each round is a function of the pose, and the last one has only found
 * that all pins hold, or that a few steps of the whole body gain nothing.
 *
 * Returns how many iterations its solves took.
 */
export function holdPins(
  {
    character,
    pins,
    natures: settings,
    followed,
  }: Pick<PoseContext, 'character' | 'pins' | 'natures' | 'followed'>,
  q: Float64Array,
): number {
  const { skeleton } = character;
  const goals = pins.flatMap((pin, at): IkGoal[] => {
    if (pin.weight === 0) return [];
    const { place, rotation } = pinTarget(pin, followed, at);
    const { joint, point, weight } = pin;
    return [{ joint, point, target: place, weight, ...(rotation && { rotation }) }];
  });
  if (goals.length === 0) return 0;
  const { limbs, body } = freedJoints(
    skeleton,
    pins.filter(({ weight }) => weight > 0),
  );
  const natures = naturesInUse(character, settings);
  const measure = new Measure(skeleton, goals);
  let iterations = 0;
  const solve = (freed: Freed, most: number): Float64Array => {
    const own = freed.pins.map((pin) => goals[pin]!);
    const isBody = freed === body;
    const problem = {
      skeleton,
      goals: own,
      joints: freed.joints,
      reference: q,
      natures: isBody ? withFirmRoots(skeleton, natures) : natures,
    };
    const options = { iterations: most, restarts: 0, tolerance: tolerance / 2 };
    const solution = isBody
      ? plainDls.solve(problem, options)
      : dls.solve(problem, { ...options, keepsNatures: true });
    iterations += solution.iterations;
    return solution.q;
  };
  for (let round = 0; round < mostRounds; round++) {
    const { cost, holds } = measure.of(q);
    if (holds.every(Boolean)) break;
    if (measure.of(solve(body, fewSteps)).cost > cost * (1 - leastGain)) break;
    for (const limb of limbs) {
      const now = measure.of(q).holds;
      if (!limb.pins.every((pin) => now[pin])) q.set(solve(limb, mostSteps.limb));
    }
    if (!measure.of(q).holds.every(Boolean)) q.set(solve(body, mostSteps.body));
  }
  return iterations;
}

/** The natures, with those of roots that have none. */
function withFirmRoots(skeleton: Skeleton, natures: readonly JointNature[]): JointNature[] {
  const firm = natures.slice();
  const free = [-Infinity, Infinity] as const;
  skeleton.parents.forEach((parent, joint) => {
    if (parent !== noParent || natures.some((nature) => nature.joint === joint)) return;
    const ranges = { bend: free, side: free, twist: free };
    firm.push({ joint, stiffness: rootStiffness, jointFromNature: [0, 0, 0, 1], ...ranges });
  });
  return firm;
}

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
