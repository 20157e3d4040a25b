import { add, cross, scale, unit, type Vector3 } from '../vector.ts';
import { atlas, placeIn } from './atlas.ts';
import { bothSides, type InsectJoint, locked } from './joints.ts';
import { chainWeights, places, profile, roundedEnd } from './profile.ts';
import { framesAlong, type Station, type Surface, sweep } from './sweep.ts';

const headJoint: Vector3 = [0, 0.485, 0.5];
const mandibleJoint: Vector3 = [0.05, 0.375, 0.655];
const antennaJoint: Vector3 = [0.034, 0.535, 0.695];

/** When bound, the scape points forward, up and outward; the flagellum continues from its end. */
const scapeDirection = unit([0.32, 0.62, 0.6]);
const scapeLength = 0.13;
const flagellumJoint = add(antennaJoint, scale(scapeDirection, scapeLength));
const flagellumBeads = 11;

const capsule = profile([
  // −y, z of the center, half the width, half the depth
  [-0.655, 0.575, 0.1, 0.06],
  [-0.62, 0.58, 0.14, 0.088],
  [-0.57, 0.595, 0.16, 0.104],
  [-0.51, 0.61, 0.163, 0.108],
  [-0.45, 0.62, 0.14, 0.098],
  [-0.4, 0.63, 0.105, 0.08],
  [-0.36, 0.64, 0.078, 0.06],
  [-0.335, 0.645, 0.06, 0.045],
]);

const rigid = (joint: string): Station['weights'] => [[joint, 1]];

/** The head's capsule, swept from the top down; its front is at the top of the texture region. */
export function headSurface(): Surface {
  const [start, end] = [0.66, 0.33];
  const stations = places(22).map((t): Station => {
    const y = start + (end - start) * t;
    const [z, width, depth] = capsule(-y);
    const cap = roundedEnd(start - y, 0.05) * roundedEnd(y - end, 0.03);
    return {
      center: [0, y, z!],
      side: [1, 0, 0],
      up: [0, 0, 1],
      width: width! * cap,
      height: depth! * cap,
      along: t,
      weights: rigid('head'),
    };
  });
  return sweep(stations, 26, placeIn(atlas.head, [0, 1]));
}

/** The left compound eye, an egg that leans with the flank of the head. */
export function eyeSurface(): Surface {
  const down = unit([-0.22, -1, 0.16]);
  const up = unit(cross(down, cross([1, 0, 0.35], down)));
  const side = cross(up, down);
  const center: Vector3 = [0.123, 0.535, 0.602];
  const stations = Array.from({ length: 13 }, (_, index): Station => {
    const angle = (index / 12) * Math.PI;
    return {
      center: add(center, scale(down, -0.112 * Math.cos(angle))),
      side,
      up,
      width: 0.082 * Math.sin(angle),
      height: 0.07 * Math.sin(angle) * (1 + 0.08 * Math.cos(angle)),
      along: index / 12,
      weights: rigid('head'),
    };
  });
  return sweep(stations, 18, placeIn(atlas.eye, [0, 1]));
}

/** Rotates a point about an axis through a pivot. */
function turned(point: Vector3, pivot: Vector3, axis: Vector3, angle: number): Vector3 {
  const arm: Vector3 = [point[0] - pivot[0], point[1] - pivot[1], point[2] - pivot[2]];
  const along = arm[0] * axis[0] + arm[1] * axis[1] + arm[2] * axis[2];
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const turnedArm = add(
    scale(arm, c),
    add(scale(cross(axis, arm), s), scale(axis, along * (1 - c))),
  );
  return add(pivot, turnedArm);
}

function tube(
  points: readonly Vector3[],
  radius: (t: number) => number,
  weights: (t: number) => Station['weights'],
  flat = 1,
): Station[] {
  const frames = framesAlong(points, [0, 1, 0.01]);
  return points.map((center, index): Station => {
    const t = index / (points.length - 1);
    const width = radius(t);
    return {
      center,
      ...frames[index]!,
      width,
      height: width * flat,
      along: t,
      weights: weights(t),
    };
  });
}

/**
 * The left mandible, a sickle that closes in front of the mouth.
 *
 * @param alert 0 as bound, 1 wide open
 */
export function mandibleSurface(alert: number): Surface {
  const shape = profile([
    [0, 0.05, 0.395, 0.635],
    [0.25, 0.07, 0.355, 0.665],
    [0.5, 0.074, 0.325, 0.7],
    [0.75, 0.05, 0.303, 0.728],
    [1, 0.008, 0.292, 0.738],
  ]);
  const points = places(15).map((t): Vector3 => {
    const [x, y, z] = shape(t);
    return turned([x!, y!, z!], mandibleJoint, [0, 0.92, 0.39], 0.62 * alert);
  });
  const radius = (t: number): number => (0.031 - 0.025 * t) * roundedEnd(1.001 - t, 0.12);
  const stations = tube(points, radius, () => rigid('mandible_l'), 0.8);
  return sweep(stations, 12, placeIn(atlas.mandible, [0, 1]));
}

/**
 * The left antenna: a scape, and a beaded flagellum that curls down at its end.
 *
 * @param alert 0 as bound, 1 raised and stretched
 */
export function antennaSurface(alert: number): Surface {
  const points: Vector3[] = [0, 0.02, 0.12, 0.35, 0.65, 0.88].map((t) =>
    add(antennaJoint, scale(scapeDirection, t * scapeLength)),
  );
  const scapeCount = points.length;
  const steps = 34;
  let point = flagellumJoint;
  points.push(point);
  for (let step = 1; step <= steps; step++) {
    const t = step / steps;
    const pitch = 0.75 - (2.1 - 1.3 * alert) * t ** 1.2;
    const yaw = 0.5 + (0.35 + 0.15 * alert) * t;
    const forward: Vector3 = [
      Math.cos(pitch) * Math.sin(yaw),
      Math.sin(pitch),
      Math.cos(pitch) * Math.cos(yaw),
    ];
    point = add(point, scale(forward, 0.62 / steps));
    points.push(point);
  }
  const raised = points.map((each) => turned(each, antennaJoint, [-0.9, 0, 0.43], 0.3 * alert));
  const bead = (t: number): number => (Math.max(0, t * 1.15 - 0.15) * flagellumBeads) % 1;
  const radius = (t: number): number =>
    (0.0175 - 0.009 * t) * (0.9 + 0.14 * bead(t)) * roundedEnd(1.0005 - t, 0.03);
  const elbow = scapeCount / (points.length - 1);
  const weights = (t: number): Station['weights'] =>
    chainWeights(
      [
        ['antenna_l_scape', -Infinity, 0],
        ['antenna_l_flagellum', elbow, 0.05],
      ],
      t,
    );
  const stations = tube(raised, radius, weights);
  return sweep(stations, 8, placeIn(atlas.antenna, [0, 1], undefined, flagellumBeads));
}

export function headJoints(): InsectJoint[] {
  const head: InsectJoint = {
    name: 'head',
    parent: 'body',
    position: headJoint,
    bind: [0, 0, 0],
    limits: [
      [-0.5, 0.6],
      [-0.6, 0.6],
      [-0.7, 0.7],
    ],
  };
  const scape = bothSides({
    name: 'antenna_l_scape',
    parent: 'head',
    position: antennaJoint,
    bind: [0, 0, 0],
    limits: [
      [-0.8, 0.9],
      [-0.5, 0.9],
      [-0.4, 0.4],
    ],
  });
  const flagellum = bothSides({
    name: 'antenna_l_flagellum',
    parent: 'antenna_l_scape',
    position: flagellumJoint,
    bind: [0, 0, 0],
    limits: [[-0.6, 0.6], [-0.5, 0.5], locked],
  });
  const mandible = bothSides({
    name: 'mandible_l',
    parent: 'head',
    position: mandibleJoint,
    bind: [0, 0, 0],
    limits: [locked, [-0.1, 0.75], locked],
  });
  const pairs = [0, 1].flatMap((side) => [scape[side]!, flagellum[side]!]);
  return [head, ...pairs, ...mandible];
}
