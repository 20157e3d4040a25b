import { DofKind } from '../../core/skeleton.ts';
import { AxisTurn } from './axis-turn.ts';
import { type Move, type Sweeper, naturalSweeps } from './sweeps.ts';

/** How often the hinges of a joint take turns to point it where it should. */
const rounds = 3;

/** How much the next places of the chain count when a joint is turned. */
const placeWeights = [
  [1, 1],
  [2, 0.3],
] as const;

const turn = new AxisTurn();

/**
 * Forward and backward reaching (Aristidou and Lasenby 2011): the joints of a goal's chain are taken
 * as points that keep their distances, first pulled from the target to the root and then back from
 * the root. After that each joint, from the root, turns its next point to where that put it, as far
 * as its degrees of freedom and limits allow. Several goals take turns; slides rest.
 */
export const fabrik = naturalSweeps(function* sweep(sweeper: Sweeper): Generator<Move> {
  for (let goal = 0; goal < sweeper.problem.goals.length; goal++) {
    const wanted = reach(sweeper, goal);
    for (let i = 0; i + 1 < wanted.length; i++) yield* point(sweeper, goal, i, wanted);
  }
});

/** Where the joints of a goal's chain, and its point at the end, would be if they were free. */
function reach(sweeper: Sweeper, goal: number): number[][] {
  const { joints } = sweeper.chains[goal]!;
  const places = [...joints.keys(), joints.length].map((link) => placeOf(sweeper, goal, link));
  const lengths = places.slice(1).map((place, i) => distance(place, places[i]!));
  const root = places[0]!;
  places[places.length - 1] = [...sweeper.problem.goals[goal]!.target];
  for (let i = places.length - 2; i >= 0; i--)
    places[i] = atDistance(places[i + 1]!, places[i]!, lengths[i]!);
  places[0] = root;
  for (let i = 1; i < places.length; i++)
    places[i] = atDistance(places[i - 1]!, places[i]!, lengths[i - 1]!);
  return places;
}

/**
 * Turns a joint of the chain so that the next place of the chain comes nearest to where it should be.
 * The place after it counts a little, because it decides the twist: a knee that is a hinge bends only
 * in the plane that the hip gives it.
 */
function* point(
  sweeper: Sweeper,
  goal: number,
  link: number,
  wanted: readonly (readonly number[])[],
): Generator<Move> {
  const { space, kinematics, chains } = sweeper;
  const joint = chains[goal]!.joints[link]!;
  for (let round = 0; round < rounds; round++) {
    for (let column = space.joints.indexOf(joint); space.joints[column] === joint; column++) {
      if (space.kinds[column] === DofKind.slide) continue;
      turn.clear();
      for (const [ahead, weight] of placeWeights) {
        const target = wanted[link + ahead];
        if (!target) continue;
        const next = placeOf(sweeper, goal, link + ahead);
        turn.add(kinematics.axes, kinematics.origins, column * 3, next, 0, target, weight);
      }
      const moved = sweeper.move(column, turn.angle);
      if (moved !== 0) yield { column, moved };
    }
  }
}

/** The origin of a joint of the chain, or the goal's point after the last one. */
function placeOf({ chains, kinematics }: Sweeper, goal: number, link: number): number[] {
  const joint = chains[goal]!.joints[link];
  if (joint === undefined) return [...kinematics.points.subarray(goal * 3, goal * 3 + 3)];
  const at = joint * 16 + 12;
  return [...kinematics.characterFromJoint.subarray(at, at + 3)];
}

/** The point at a distance from `from` in the direction of `towards`; any direction if they agree. */
function atDistance(from: readonly number[], towards: readonly number[], length: number): number[] {
  const apart = distance(from, towards);
  if (apart < 1e-12) return [from[0]!, from[1]! + length, from[2]!];
  return from.map((value, axis) => value + ((towards[axis]! - value) * length) / apart);
}

function distance(a: readonly number[], b: readonly number[]): number {
  return Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);
}
