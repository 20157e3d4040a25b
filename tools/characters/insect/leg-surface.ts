import { add, cross, mix, scale, subtract, unit, type Vector3 } from '../vector.ts';
import { atlas, placeIn } from './atlas.ts';
import { boundPoints, type Leg } from './legs.ts';
import { chainWeights, profile, roundedEnd } from './profile.ts';
import { joined, type Station, type Surface, sweep } from './sweep.ts';

const segments = 10;

/** The distance from a joint at which its bend begins and ends, in model units. */
const bend = 0.045;

/** Half the thickness of a middle leg. Places count segments: 1.5 is halfway down the femur. */
const thickness = profile([
  [0, 0.03],
  [0.3, 0.052],
  [0.62, 0.042],
  [1, 0.0215],
  [1.08, 0.0225],
  [1.35, 0.043],
  [1.7, 0.03],
  [1.95, 0.02],
  [2.05, 0.02],
  [2.2, 0.0185],
  [2.6, 0.021],
  [2.88, 0.027],
  [3, 0.015],
]);

/** The positions of the rings on each segment between the bends, from 0 to 1. */
const ringsOf: readonly (readonly number[])[] = [
  [0.05, 0.2, 0.42, 0.58],
  [0.17, 0.26, 0.36, 0.48, 0.62, 0.76],
  [0.17, 0.32, 0.5, 0.66, 0.79],
];

const tarsusBeads = 5;

/** A point of the leg's center line and its place on it, in segments. */
interface LinePoint {
  readonly point: Vector3;
  readonly place: number;
}

/** The center line from base to ankle, with rounded corners. */
function middleLine(corners: readonly Vector3[]): LinePoint[] {
  const line: LinePoint[] = [];
  for (let segment = 0; segment < 3; segment++) {
    const [from, to] = [corners[segment]!, corners[segment + 1]!];
    for (const t of ringsOf[segment]!) line.push({ point: mix(from, to, t), place: segment + t });
    line.push(...corner(from, to, corners[segment + 2]!, segment + 1));
  }
  return line;
}

/** Five points of the parabola that is tangent to both segments at a joint. */
function corner(from: Vector3, joint: Vector3, to: Vector3, place: number): LinePoint[] {
  const [before, after] = [subtract(from, joint), subtract(to, joint)];
  const [lengthBefore, lengthAfter] = [Math.hypot(...before), Math.hypot(...after)];
  const start = add(joint, scale(before, bend / lengthBefore));
  const end = add(joint, scale(after, bend / lengthAfter));
  return [0, 0.25, 0.5, 0.75, 1].map((t) => ({
    point: mix(mix(start, joint, t), mix(joint, end, t), t),
    place:
      place + (t < 0.5 ? (2 * t - 1) * (bend / lengthBefore) : (2 * t - 1) * (bend / lengthAfter)),
  }));
}

/** Frames of a line in the plane of the leg, with their sides toward the back. */
function stationsOf(
  line: readonly LinePoint[],
  leg: Leg,
  radius: (place: number) => number,
): Station[] {
  const begin = (joint: number): number => bend / Object.values(leg.lengths)[joint - 1]!;
  const chain = [
    [`${leg.name}_coxa`, -Infinity, 0],
    [`${leg.name}_femur`, 1, 0.2],
    [`${leg.name}_tibia`, 2, 1.3 * begin(1)],
    [`${leg.name}_tarsus`, 3, 1.3 * begin(3)],
  ] as const;
  return line.map(({ point, place }, index) => {
    const before = line[Math.max(0, index - 1)]!.point;
    const after = line[Math.min(line.length - 1, index + 1)]!.point;
    const side: Vector3 = [0, 0, -1];
    const height = radius(place) * leg.bulk;
    return {
      center: point,
      side,
      up: cross(unit(subtract(after, before)), side),
      width: height * (place < 2 ? 0.82 : 0.95),
      height,
      along: place,
      weights: chainWeights(chain, place),
    };
  });
}

/** The foot has five beads, each wider toward its end, and a bent claw. */
function tarsusRadius(place: number): number {
  const t = place - 3;
  const bead = (t * tarsusBeads) % 1;
  const taper = 0.0165 - 0.0065 * t;
  const beaded = taper * (0.74 + 0.42 * bead * bead);
  return beaded * roundedEnd(1.001 - t, 0.05);
}

function tarsusLine(ankle: Vector3, tip: Vector3): LinePoint[] {
  const steps = [0.02, 0.45, 0.8, 0.97];
  return Array.from({ length: tarsusBeads }, (_, bead) => bead)
    .flatMap((bead) => steps.map((step) => (bead + step) / tarsusBeads))
    .concat(1)
    .filter((t) => t > 0.1)
    .map((t) => ({ point: mix(ankle, tip, t), place: 3 + t }));
}

/** A left leg from coxa to foot, in two closed surfaces: one down to the ankle, and the foot. */
export function legSurface(leg: Leg): Surface {
  const corners = boundPoints(leg);
  const [, , , ankle, tip] = corners;
  const radius = (place: number): number => thickness(place)[0]!;
  const upper = middleLine(corners);
  const line = [
    { point: corners[0], place: 0 },
    ...upper,
    { point: mix(ankle, tip, 0.22), place: 3.22 },
  ];
  const shaft = stationsOf(line, leg, radius);
  const foot = stationsOf(
    [{ point: ankle, place: 3 }, ...tarsusLine(ankle, tip)],
    leg,
    tarsusRadius,
  );
  return joined([
    sweep(shaft, segments, placeIn(atlas.leg, [0, 3.25])),
    sweep(foot, segments - 3, placeIn(atlas.tarsus, [3, 4], undefined, tarsusBeads)),
  ]);
}
