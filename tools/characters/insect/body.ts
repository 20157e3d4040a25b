import type { Vector3 } from '../vector.ts';
import { atlas, placeIn } from './atlas.ts';
import { type InsectJoint } from './joints.ts';
import { chainWeights, places, profile, roundedEnd } from './profile.ts';
import { type Station, type Surface, sweep } from './sweep.ts';

/** The positions of the abdomen's joints: z, going backward, and y. */
const abdomenJoints = [
  { name: 'abdomen1', z: -0.27, y: 0.45 },
  { name: 'abdomen2', z: -0.53, y: 0.455 },
  { name: 'abdomen3', z: -0.75, y: 0.435 },
] as const;

/** The z of the end of each plate of the abdomen. */
export const plates = [-0.36, -0.485, -0.6, -0.7, -0.79, -0.87, -0.945] as const;

export const abdomenRange = [-0.16, -1.1] as const;
export const thoraxRange = [0.55, -0.29] as const;

const thoraxShape = profile([
  // −z, y of the center, half the width, half the height, belly
  [-0.55, 0.475, 0.05, 0.05, 1],
  [-0.47, 0.475, 0.07, 0.075, 1],
  [-0.42, 0.482, 0.128, 0.12, 0.95],
  [-0.37, 0.487, 0.142, 0.138, 0.9],
  [-0.345, 0.487, 0.138, 0.134, 0.9],
  [-0.315, 0.492, 0.152, 0.154, 0.85],
  [-0.24, 0.5, 0.172, 0.185, 0.82],
  [-0.12, 0.503, 0.182, 0.198, 0.82],
  [-0.02, 0.497, 0.17, 0.184, 0.86],
  [0.03, 0.49, 0.155, 0.168, 0.9],
  [0.055, 0.487, 0.15, 0.162, 0.9],
  [0.12, 0.476, 0.135, 0.142, 0.95],
  [0.2, 0.462, 0.098, 0.105, 1],
  [0.26, 0.452, 0.052, 0.055, 1],
  [0.29, 0.45, 0.03, 0.03, 1],
]);

const abdomenShape = profile([
  [0.16, 0.455, 0.04, 0.04, 1],
  [0.24, 0.452, 0.028, 0.03, 1],
  [0.3, 0.452, 0.026, 0.028, 1],
  [0.34, 0.454, 0.04, 0.044, 1],
  [0.38, 0.458, 0.08, 0.086, 0.95],
  [0.46, 0.462, 0.142, 0.146, 0.85],
  [0.57, 0.458, 0.174, 0.172, 0.82],
  [0.68, 0.446, 0.166, 0.162, 0.82],
  [0.79, 0.424, 0.132, 0.132, 0.85],
  [0.88, 0.396, 0.09, 0.092, 0.9],
  [0.96, 0.366, 0.048, 0.05, 0.95],
  [1.01, 0.344, 0.02, 0.022, 1],
  [1.06, 0.324, 0.009, 0.01, 1],
  [1.1, 0.31, 0.004, 0.004, 1],
]);

/** The surface swells just before the end of each plate and steps inward behind it. */
function plateRelief(z: number): number {
  let relief = 0;
  for (const [index, end] of plates.entries()) {
    const start = index === 0 ? -0.3 : plates[index - 1]!;
    const t = (z - start) / (end - start);
    if (t >= 0 && t < 1) relief = 0.05 * t * t - 0.02;
  }
  return z < -0.34 && z > -0.95 ? relief : 0;
}

/** How far the abdomen swells at a z when the insect breathes in, from 0 to 1. */
function swelling(z: number): number {
  const t = (-z - 0.34) / 0.62;
  return t > 0 && t < 1 ? Math.sin(Math.PI * t) ** 1.5 : 0;
}

const back: Vector3 = [-1, 0, 0];
const up: Vector3 = [0, 1, 0];

function ring(z: number, shape: readonly number[], swell: number): Omit<Station, 'weights'> {
  const [y, width, height, belly] = shape;
  const grown = 1 + 0.16 * swell;
  return {
    center: [0, y! - 0.02 * swell, z],
    side: back,
    up,
    width: width! * grown,
    height: height! * grown,
    belly: belly! * (1 + 0.1 * swell),
    along: z,
  };
}

export function thoraxSurface(): Surface {
  const [start, end] = thoraxRange;
  const stations = places(32).map((t): Station => {
    const z = start + (end - start) * t;
    const cap = roundedEnd(Math.min(start - z, z - end), 0.03);
    const station = ring(z, thoraxShape(-z), 0);
    const [width, height] = [station.width * cap, station.height * cap];
    // The neck follows the head a little.
    const weights = chainWeights(
      [
        ['head', -Infinity, 0],
        ['body', -0.49, 0.05],
      ],
      -z,
    );
    return { ...station, width, height, weights };
  });
  return sweep(stations, 26, placeIn(atlas.thorax, thoraxRange));
}

/** @param breath 0 as bound, 1 breathed in */
export function abdomenSurface(breath: number): Surface {
  const chain = [
    ['body', -Infinity, 0],
    ...abdomenJoints.map(({ name, z }, index) => [name, -z, index === 0 ? 0.05 : 0.13] as const),
  ] as const;
  // There are rings on both sides of each plate's end.
  const steps = plates.slice(0, -1).flatMap((end, index) => {
    const next = plates[index + 1]!;
    return [0.03, 0.12, 0.35, 0.6, 0.82, 0.95].map((t) => end + (next - end) * t);
  });
  const petiole = [-0.16, -0.165, -0.2, -0.24, -0.27, -0.3, -0.32, -0.335, -0.348];
  const tail = [-0.948, -0.96, -0.985, -1.01, -1.04, -1.075, -1.095, -1.1];
  const stations = [...petiole, ...steps, ...tail].map((z): Station => {
    const station = ring(z, abdomenShape(-z), breath * swelling(z));
    const relief = 1 + plateRelief(z);
    const [width, height] = [station.width * relief, station.height * relief];
    return { ...station, width, height, weights: chainWeights(chain, -z) };
  });
  return sweep(stations, 26, placeIn(atlas.abdomen, abdomenRange));
}

export function bodyJoints(): InsectJoint[] {
  const first: InsectJoint = {
    name: 'body',
    parent: '',
    position: [0, 0.47, 0.05],
    bind: [0, 0, 0],
    limits: [
      [-0.6, 0.6],
      [-3.1416, 3.1416],
      [-0.6, 0.6],
    ],
  };
  const abdomen = abdomenJoints.map(({ name, z, y }, index): InsectJoint => {
    const parent = index === 0 ? 'body' : abdomenJoints[index - 1]!.name;
    const limits: InsectJoint['limits'] =
      index === 0
        ? [
            [-0.7, 0.6],
            [-0.5, 0.5],
            [-0.3, 0.3],
          ]
        : [
            [-0.5, 0.25],
            [-0.25, 0.25],
            [0, 0],
          ];
    return { name, parent, position: [0, y, z], bind: [0, 0, 0], limits };
  });
  return [first, ...abdomen];
}
