import { quat } from 'gl-matrix';
import { DofKind } from '../../core/skeleton.ts';
import { type LabChain, pathPlaces, problemOf } from './lab-chain.ts';
import type { IkSolver, Vector3 } from './problem.ts';

/** A kind of target that shows something about the methods. */
export type TargetKind = 'reachable' | 'far' | 'close' | 'straight';

/** A target in the character's space, and the pose from which it is to be reached. */
export interface LabTask {
  readonly target: Vector3;
  readonly q: Float64Array;
}

/** Where targets lie on the line from the chain's root to the effector, as parts of its length. */
const [tooFar, tooClose, alongLimb] = [1.3, 0.04, 0.75];
/** How far a target that can be reached is from the effector, as a part of the chain's length. */
const usefulOffset = 0.5;
/** The largest turn of a value on the way to such a target, in radians. */
const largestTurn = 1.2;
const candidateCount = 24;
/** Multiples of it are spread evenly over a range. */
const golden = (Math.sqrt(5) - 1) / 2;

/**
 * Returns a target of a kind for a chain in a pose. The same chain and pose have the same target.
 *
 * @param solver stretches the limb out, for the kind that begins so
 */
export function labTask(
  kind: TargetKind,
  chain: LabChain,
  q: Float64Array,
  solver: IkSolver,
): LabTask {
  switch (kind) {
    case 'reachable':
      return { target: reachableTarget(chain, q), q };
    case 'far':
      return { target: placeAlong(chain, q, tooFar), q };
    case 'close':
      return { target: placeAlong(chain, q, tooClose), q };
    case 'straight': {
      // Which pose is straight follows from the axes and limits of all joints: the solver finds it
      // on the way to a target far beyond reach.
      const beyond = problemOf(chain, q, placeAlong(chain, q, 2));
      const straight = solver.solve(beyond, { restarts: 0, iterations: 200 }).q;
      return { target: placeAlong(chain, straight, alongLimb), q: straight };
    }
  }
}

/**
 * The place that the effector has in another pose within the limits, about half of the chain's length
 * from where it is.
 */
function reachableTarget(chain: LabChain, q: Float64Array): Vector3 {
  const here = pathPlaces(chain, q).at(-1)!;
  const wanted = usefulOffset * chain.length;
  const offBy = (place: Vector3): number => Math.abs(distance(here, place) - wanted);
  return Array.from({ length: candidateCount }, (_, seed) =>
    pathPlaces(chain, turned(chain, q, seed)).at(-1)!,
  ).reduce((best, place) => (offBy(place) < offBy(best) ? place : best));
}

function placeAlong(chain: LabChain, q: Float64Array, part: number): Vector3 {
  const places = pathPlaces(chain, q);
  const [root, end] = [places[0]!, places.at(-1)!];
  const away = distance(root, end);
  const by = part * chain.length;
  const along = (axis: 0 | 1 | 2): number => {
    const direction = away > 0 ? (end[axis] - root[axis]) / away : axis === 1 ? 1 : 0;
    return root[axis] + direction * by;
  };
  return [along(0), along(1), along(2)];
}

/** Turns each of the chain's values by an amount that depends on it and the seed, within its limits. */
function turned({ skeleton, moving }: LabChain, from: Float64Array, seed: number): Float64Array {
  const { dofStart, dofKind, dofQ, qMin, qMax } = skeleton;
  const q = from.slice();
  let count = seed * 17;
  const next = (): number => (((++count * golden) % 1) * 2 - 1) * largestTurn;
  for (const joint of moving) {
    for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
      const index = dofQ[dof]!;
      if (dofKind[dof] === DofKind.hinge) {
        q[index] = Math.min(Math.max(q[index]! + next(), qMin[index]!), qMax[index]!);
      } else if (dofKind[dof] === DofKind.ball) {
        const ball = q.subarray(index, index + 4);
        quat.rotateX(ball, ball, next());
        quat.rotateZ(ball, ball, next());
        quat.normalize(ball, ball);
      }
    }
  }
  return q;
}

function distance(a: Vector3, b: Vector3): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
