import { jointRange } from '../../core/pose.ts';
import { sameValue } from '../../core/same-value.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import type {
  IkOptions,
  IkProblem,
  IkSolution,
  IkSolver,
  IkStep,
  JointNature,
} from '../ik/problem.ts';
import { pullPose } from '../ik/pull-pose.ts';
import { bendToReach } from './reach-bend.ts';
import {
  fromNatural,
  naturalSkeleton,
  type NaturalSkeleton,
  swingAngles,
  toNatural,
} from './natural-skeleton.ts';

/** How far a soft range gives way at both ends, but never by more than its own width, in radians. */
const slack = (10 * Math.PI) / 180;

/** A joint with a narrower range sideways, in radians, bends like a hinge: an elbow or a knee. */
const hingeWidth = (15 * Math.PI) / 180;

/** What the soft ranges are in one attempt after another; in the last, only tasks of the solver. */
type Attempt = 'within' | 'a little outside' | 'only hinges' | 'outside';
const attempts: readonly Attempt[] = ['within', 'a little outside', 'only hinges', 'outside'];

/**
 * Makes a solver keep to the natures of a problem's joints. It solves in natural coordinates, where
 * soft ranges are limits. Only if a goal within reach is missed there, they give way: first all of
 * them a little, then all but those of hinges, and at last those too; each attempt starts where the
 * one before ended. What starts outside a range may stay there but not go farther out, so that
 * nothing jumps when a drag begins.
 */
export function natural(solver: IkSolver): IkSolver {
  return {
    solve(problem, options = {}) {
      const run = runOf(problem, options);
      if (!run) return solver.solve(problem, options);
      let best: IkSolution | undefined;
      let iterations = 0;
      for (const attempt of attempts) {
        const task = taskOf(run, attempt);
        const found = task.back(solver.solve(task.problem, task.options));
        iterations += found.iterations;
        if (!best || missOf(found, problem) < missOf(best, problem)) best = found;
        // What may turn only so far from the start is measured from there in every attempt.
        if (options.mostTurn === undefined) run.from = best.q;
        if (isDone(found) || isCut(found, options)) break;
      }
      return { ...best!, iterations };
    },
    *steps(problem, options = {}) {
      const run = runOf(problem, options);
      if (!run) {
        yield* solver.steps(problem, options);
        return;
      }
      for (const attempt of attempts) {
        const task = taskOf(run, attempt);
        let isStart = true;
        for (const step of solver.steps(task.problem, task.options)) {
          // An attempt begins where the one before ended, which was shown already.
          if (!isStart || attempt === 'within') yield task.backStep(step);
          isStart = false;
        }
        const found = task.back(solver.solve(task.problem, task.options));
        if (options.mostTurn === undefined) run.from = found.q;
        if (isDone(found) || isCut(found, options)) return;
      }
    },
  };
}

/**
 * Pulls a pose a part of the way to another one, in natural coordinates: in those of the file, an elbow
 * that is pulled straight would begin to twist.
 */
export function pullNaturally(
  problem: IkProblem,
  from: Float64Array,
  to: Float64Array,
  part: number,
): Float64Array {
  const natural = naturalOf(problem);
  const start = toNatural(natural, from);
  const pulled = pullPose(natural.skeleton, start, toNatural(natural, to), part);
  return fromNatural(natural, pulled, start, from);
}

/** A solve in progress. */
interface Run {
  /** With ranges that are as wide as the start needs. */
  readonly problem: IkProblem;
  readonly options: IkOptions;
  readonly natural: NaturalSkeleton;
  /** (qCount) where the next attempt starts. */
  from: Float64Array;
}

/** The same problem for the solver, in other coordinates, and the way back. */
interface Task {
  readonly problem: IkProblem;
  readonly options: IkOptions;
  readonly back: (solution: IkSolution) => IkSolution;
  readonly backStep: (step: IkStep) => IkStep;
}

/** Null where no joint of the problem has a nature. */
function runOf(problem: IkProblem, options: IkOptions): Run | null {
  const { skeleton, joints, reference } = problem;
  const natural = naturalOf(problem);
  if (natural.natures.length === 0) return null;
  const from = reference.slice();
  for (const joint of joints) {
    const [first, end] = jointRange(skeleton, joint);
    from.set((options.from ?? reference).subarray(first, end), first);
  }
  const natures = natural.natures.map((nature) =>
    widened(nature, swingAngles(skeleton, nature, from)),
  );
  return { problem: { ...problem, natures }, options, natural, from };
}

const known = new WeakMap<readonly JointNature[], NaturalSkeleton[]>();
/** As many limbs as a body has, each with its own joints. */
const mostKnown = 8;

/** A drag asks for the same natures and joints in every frame. */
function naturalOf({ skeleton, joints, natures }: IkProblem): NaturalSkeleton {
  const own = natures.filter(({ joint }) => joints.includes(joint));
  const earlier = known.get(natures) ?? [];
  const found = earlier.find((each) => each.own === skeleton && sameValue(each.natures, own));
  if (found) return found;
  const natural = naturalSkeleton(skeleton, own);
  known.set(natures, [natural, ...earlier].slice(0, mostKnown));
  return natural;
}

function widened(nature: JointNature, [bend, side, twist]: readonly number[]): JointNature {
  const around = ([low, high]: readonly [number, number], value: number) =>
    [Math.min(low, value), Math.max(high, value)] as const;
  return {
    ...nature,
    bend: around(nature.bend, bend!),
    side: around(nature.side, side!),
    twist: around(nature.twist, twist!),
  };
}

function taskOf(run: Run, attempt: Attempt): Task {
  const { problem, options, natural, from } = run;
  if (attempt === 'outside') {
    const same = <T>(value: T): T => value;
    return { problem, options: { ...options, from }, back: same, backStep: same };
  }
  const start = toNatural(natural, from);
  const skeleton = limitedSkeleton(natural, start, attempt);
  const reference = toNatural(natural, problem.reference);
  for (const { nature, index } of natural.joints) {
    if (isHinge(nature)) reference[index]! += bendToReach(problem, nature.joint);
  }
  for (let i = 0; i < reference.length; i++) {
    if (natural.sources[i]! >= 0) continue;
    reference[i] = Math.min(Math.max(reference[i]!, skeleton.qMin[i]!), skeleton.qMax[i]!);
  }
  const back = <T extends IkSolution | IkStep>(found: T): T => ({
    ...found,
    q: fromNatural(natural, found.q, start, from),
    atLimits: found.atLimits.map((i) => natural.sources[i]!).filter((source) => source >= 0),
  });
  return {
    problem: { ...problem, skeleton, reference },
    options: { ...options, from: start },
    back,
    backStep: back,
  };
}

/** The skeleton with the soft ranges of an attempt. */
function limitedSkeleton(
  natural: NaturalSkeleton,
  start: Float64Array,
  attempt: Attempt,
): Skeleton {
  const { skeleton } = natural;
  const qMin = skeleton.qMin.slice();
  const qMax = skeleton.qMax.slice();
  for (const { nature, index } of natural.joints) {
    const isSoft = attempt === 'only hinges' && !isHinge(nature);
    const most = attempt === 'within' ? 0 : isSoft ? Infinity : slack;
    for (let i = index; i < index + 3; i++) {
      const give = most === Infinity ? most : Math.min(most, qMax[i]! - qMin[i]!);
      qMin[i] = Math.min(qMin[i]! - give, start[i]!);
      qMax[i] = Math.max(qMax[i]! + give, start[i]!);
    }
  }
  return { ...skeleton, qMin, qMax };
}

function isHinge({ side }: JointNature): boolean {
  return side[1] - side[0] < hingeWidth;
}

/** How far a solution is from the goals. */
function missOf({ residuals, turns }: IkSolution, { goals }: IkProblem): number {
  return goals.reduce((sum, { weight }, goal) => {
    return sum + weight * (residuals[goal]! ** 2 + turns[goal]! ** 2);
  }, 0);
}

/** Whether a drag's frame ended before it could tell that the ranges have to give way. */
function isCut(
  { iterations }: IkSolution,
  { iterations: most, restarts, keepsNatures = false }: IkOptions,
): boolean {
  if (keepsNatures) return true;
  return restarts === 0 && most !== undefined && iterations >= most;
}

function isDone({ status }: IkSolution): boolean {
  return status === 'reached' || status === 'out-of-reach';
}
