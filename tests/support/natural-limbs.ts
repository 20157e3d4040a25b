import { bonesOf } from '../../src/core/bones.ts';
import type { Character } from '../../src/core/character.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { dls } from '../../src/posing/ik/dls.ts';
import type { IkProblem, JointNature } from '../../src/posing/ik/problem.ts';
import { randomBetween, randomSource, randomUnitVector } from './random.ts';

/** `npm run test:long` sets it to 300. */
const targetCount = Number(process.env['NATURAL_TARGETS'] ?? 24);

/** An arm or a leg by the names of its joints; without an end it ends at the tip of its last bone. */
export interface Limb {
  readonly kind: 'arm' | 'leg';
  /** The joints that move, from the outermost. The last one bends the limb. */
  readonly chain: readonly string[];
  readonly end?: string;
  /** Where the character looks to, as a person sees it. */
  readonly forward: readonly [number, number, number];
}

/** How a limb is bent in a pose, in degrees. */
interface Bend {
  /** How far the lower limb is out of the plane in which it should bend. */
  readonly outOfPlane: number;
  /** From the straight limb, forward at an elbow and backward at a knee. */
  readonly bend: number;
  /** How far the lower limb is rotated about itself from the rest pose. */
  readonly twist: number;
}

/** A limb that stands bent farther, in degrees, shows its plane. */
const shown = 15;

type Vector = readonly [number, number, number];

/**
 * Solves for targets in front of a limb, each from rest and in rows of twelve, where each drag starts
 * where the last one ended. Returns the limb in every pose.
 *
 * Nothing here asks what joints are: the plane is that of the limb in the rest pose or, where it
 * stands straight, the one through `forward`.
 */
export function bendsOf(
  character: Character,
  limb: Limb,
  natures: readonly JointNature[],
  count = targetCount,
): { readonly bends: readonly Bend[]; readonly missed: number } {
  const { skeleton } = character;
  const joints = limb.chain.map((name) => skeleton.names.indexOf(name));
  const middle = joints.at(-1)!;
  const upper = skeleton.parents[middle]!;
  const last = limb.end === undefined ? middle : skeleton.names.indexOf(limb.end);
  const tip = bonesOf(character).find(({ joint }) => joint === middle)!.vector;
  const point: Vector = limb.end === undefined ? tip : [0, 0, 0];

  const rest = limbIn(skeleton.qRest);
  const axis = planeAxis();
  const restLower = unit(rest.lower);
  const length = norm(rest.upper) + norm(rest.lower);
  const random = randomSource(limb.chain.length + limb.chain[0]!.length);

  const bends: Bend[] = [];
  let missed = 0;
  for (let i = 0; i < count; i++) drag(skeleton.qRest);
  for (let row = 0; row < count / 12; row++) {
    let q = skeleton.qRest;
    for (let i = 0; i < 12; i++) q = drag(q);
  }
  return { bends, missed };

  function drag(reference: Float64Array): Float64Array {
    const goal = { joint: last, point, target: targetInFront(), weight: 1 };
    const problem: IkProblem = { skeleton, goals: [goal], joints, reference, natures };
    const { q, status } = dls.solve(problem);
    bends.push(bendIn(q));
    if (status !== 'reached') missed++;
    return q;
  }

  /** Before the body, and for legs below the hips; from 35 to 95 % of the limb's length away. */
  function targetInFront(): Vector {
    for (;;) {
      const way = randomUnitVector(random) as unknown as Vector;
      const ahead = dot(way, limb.forward);
      const isInFront = limb.kind === 'arm' ? ahead > 0.2 : ahead > 0 && way[1] < -0.3;
      if (!isInFront) continue;
      const distance = randomBetween(random, 0.35, 0.95) * length;
      return rest.root.map((at, i) => at + distance * way[i]!) as unknown as Vector;
    }
  }

  /** The limb, with its vectors in the frame of the joint that moves the upper limb. */
  function limbIn(q: Float64Array) {
    const matrices = jointMatrices(skeleton, q);
    const place = (joint: number): Vector =>
      [12, 13, 14].map((i) => matrices[joint * 16 + i]!) as never;
    const m = matrices.subarray(last * 16, last * 16 + 16);
    const end = [0, 1, 2].map(
      (row) => m[row]! * point[0] + m[4 + row]! * point[1] + m[8 + row]! * point[2] + m[12 + row]!,
    ) as unknown as Vector;
    const inUpper = (v: Vector): Vector => intoFrame(matrices, upper, v);
    const [x, y] = [0, 4].map((column): Vector => {
      const at = middle * 16 + column;
      return inUpper([matrices[at]!, matrices[at + 1]!, matrices[at + 2]!]);
    });
    return {
      root: place(upper),
      upper: inUpper(minus(place(middle), place(upper))),
      lower: inUpper(minus(end, place(middle))),
      forward: inUpper(limb.forward),
      x: x!,
      y: y!,
    };
  }

  function planeAxis(): Vector {
    const bent = cross(rest.upper, rest.lower);
    const isBent = angle(rest.upper, rest.lower) > shown;
    const ahead = cross(rest.upper, rest.forward);
    return unit(isBent ? bent : limb.kind === 'arm' ? ahead : times(ahead, -1));
  }

  function bendIn(q: Float64Array): Bend {
    const now = limbIn(q);
    const lower = unit(now.lower);
    const along = unit(rest.upper);
    const across = cross(axis, along);
    return {
      outOfPlane: degrees(Math.asin(Math.abs(dot(lower, axis)))),
      bend: degrees(Math.atan2(dot(lower, across), dot(lower, along))),
      twist: twistFromRest(now, lower),
    };
  }

  /** Turns the limb back to its rest by the shortest way; what is left is about the limb itself. */
  function twistFromRest(now: ReturnType<typeof limbIn>, lower: Vector): number {
    const back = shortestTurn(lower, restLower);
    const [x, from] = [back(now.x), rest.x];
    // The axis of the joint's frame that is more across the limb shows the twist better.
    const [seen, was] = Math.abs(dot(from, restLower)) < 0.8 ? [x, from] : [back(now.y), rest.y];
    const flat = (v: Vector): Vector => minus(v, times(restLower, dot(v, restLower)));
    const [a, b] = [flat(was), flat(seen)];
    return degrees(Math.atan2(dot(cross(a, b), restLower), dot(a, b)));
  }
}

/** The rotation by the shortest way from one unit vector to another, by Rodrigues' formula. */
function shortestTurn(from: Vector, to: Vector): (v: Vector) => Vector {
  const axis = cross(from, to);
  const cosine = dot(from, to);
  return (v) => {
    const turned = plus(times(v, cosine), cross(axis, v));
    return plus(turned, times(axis, dot(axis, v) / (1 + cosine)));
  };
}

/** Rᵀ v with the rotation of a joint's matrix. */
function intoFrame(matrices: Float64Array, joint: number, v: Vector): Vector {
  return [0, 4, 8].map(
    (column) =>
      matrices[joint * 16 + column]! * v[0] +
      matrices[joint * 16 + column + 1]! * v[1] +
      matrices[joint * 16 + column + 2]! * v[2],
  ) as unknown as Vector;
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function plus(a: Vector, b: Vector): Vector {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

function minus(a: Vector, b: Vector): Vector {
  return plus(a, times(b, -1));
}

function times(v: Vector, factor: number): Vector {
  return [v[0] * factor, v[1] * factor, v[2] * factor];
}

function norm(v: Vector): number {
  return Math.hypot(...v);
}

function unit(v: Vector): Vector {
  return times(v, 1 / norm(v));
}

function angle(a: Vector, b: Vector): number {
  return degrees(Math.acos(Math.min(1, dot(unit(a), unit(b)))));
}

function degrees(radians: number): number {
  return (radians * 180) / Math.PI;
}
