import type { Vector3 } from '../vector.ts';
import { bothSides, type InsectJoint, locked } from './joints.ts';

/**
 * A left leg. It is bound straight out to the side, in the plane z = base z. Lengths are in model
 * units.
 */
export interface Leg {
  readonly name: string;
  /** The coxa's center of rotation. */
  readonly base: Vector3;
  readonly lengths: { readonly femur: number; readonly tibia: number; readonly tarsus: number };
  /** The position of the foot when standing, at y = 0. */
  readonly foot: Vector3;
  /** The thickness relative to the middle leg's. */
  readonly bulk: number;
}

export const legs: readonly Leg[] = [
  {
    name: 'leg_l1',
    base: [0.08, 0.39, 0.32],
    lengths: { femur: 0.29, tibia: 0.29, tarsus: 0.24 },
    foot: [0.42, 0, 0.8],
    bulk: 0.9,
  },
  {
    name: 'leg_l2',
    base: [0.095, 0.385, 0.13],
    lengths: { femur: 0.34, tibia: 0.36, tarsus: 0.27 },
    foot: [0.71, 0, 0.16],
    bulk: 1,
  },
  {
    name: 'leg_l3',
    base: [0.09, 0.39, -0.06],
    lengths: { femur: 0.42, tibia: 0.48, tarsus: 0.33 },
    foot: [0.62, 0, -0.6],
    bulk: 1.12,
  },
];

/** The vector from the coxa's center of rotation to the femur's, in the coxa's frame. */
const coxaSpan: Vector3 = [0.058, -0.12, 0];

/**
 * Half the thickness of a foot's tip, in model units, which is the height of its center above the
 * floor.
 */
export const footRadius = 0.008;

/** The angle at which a foot slopes down to its tip, in radians. */
const footSlope = 0.32;

/** The angles of a leg in radians: the coxa's about y, the others about z. */
export interface LegAngles {
  readonly coxa: number;
  readonly femur: number;
  readonly tibia: number;
  readonly tarsus: number;
}

/**
 * Computes the angles that put a left leg's tip at a point. The coxa turns the plane of the leg
 * toward the point. In that plane, femur and tibia reach the ankle with the knee up, and the foot
 * keeps its slope.
 *
 * @param target in the frame of the thorax, relative to the leg's base
 */
export function reach({ lengths }: Leg, [x, y, z]: Vector3): LegAngles {
  const ankleX = Math.hypot(x, z) - coxaSpan[0] - Math.cos(footSlope) * lengths.tarsus;
  const ankleY = y - coxaSpan[1] + Math.sin(footSlope) * lengths.tarsus;
  const distance = Math.hypot(ankleX, ankleY);
  const { femur, tibia } = lengths;
  if (distance >= femur + tibia) throw new Error('a foot is out of reach');
  const opening = (near: number, far: number): number =>
    Math.acos((near * near + distance * distance - far * far) / (2 * near * distance));
  const femurUp = Math.atan2(ankleY, ankleX) + opening(femur, tibia);
  const knee = opening(femur, tibia) + opening(tibia, femur);
  return {
    coxa: Math.atan2(-z, x),
    femur: femurUp,
    tibia: -knee,
    tarsus: -footSlope - (femurUp - knee),
  };
}

/** The bound leg reaches as far outward as the standing leg, but straight to the side. */
function boundAngles(leg: Leg): LegAngles {
  const [x, z] = [leg.foot[0] - leg.base[0], leg.foot[2] - leg.base[2]];
  return { ...reach(leg, [Math.hypot(x, z), footRadius - leg.base[1], 0]), coxa: 0 };
}

/** Base, femur, knee, ankle and tip of a bound left leg, in the character's space. */
export function boundPoints(leg: Leg): [Vector3, Vector3, Vector3, Vector3, Vector3] {
  const angles = boundAngles(leg);
  const { femur, tibia, tarsus } = leg.lengths;
  const go = ([x, y, z]: Vector3, length: number, angle: number): Vector3 => [
    x + Math.cos(angle) * length,
    y + Math.sin(angle) * length,
    z,
  ];
  const hip: Vector3 = [leg.base[0] + coxaSpan[0], leg.base[1] + coxaSpan[1], leg.base[2]];
  const knee = go(hip, femur, angles.femur);
  const ankle = go(knee, tibia, angles.femur + angles.tibia);
  const tip = go(ankle, tarsus, angles.femur + angles.tibia + angles.tarsus);
  return [leg.base, hip, knee, ankle, tip];
}

/**
 * Coxae rotate about all axes, femora and tibiae are hinges, and feet also rotate a little
 * sideways.
 */
function jointsOf(leg: Leg): InsectJoint[] {
  const [base, hip, knee, ankle] = boundPoints(leg);
  const angles = boundAngles(leg);
  const hinge = (part: string, parent: string, position: Vector3, angle: number) => ({
    name: `${leg.name}_${part}`,
    parent: `${leg.name}_${parent}`,
    position,
    bind: [0, 0, angle] as const,
  });
  return [
    {
      name: `${leg.name}_coxa`,
      parent: 'body',
      position: base,
      bind: [0, 0, 0],
      limits: [
        [-0.25, 0.25],
        [-1.25, 1.25],
        [-0.35, 0.35],
      ],
    },
    {
      ...hinge('femur', 'coxa', hip, angles.femur),
      limits: [locked, locked, [-0.4, 1.7]],
    },
    {
      ...hinge('tibia', 'femur', knee, angles.tibia),
      limits: [locked, locked, [-2.6, -0.5]],
    },
    {
      ...hinge('tarsus', 'tibia', ankle, angles.tarsus),
      limits: [locked, [-0.3, 0.3], [-0.4, 1.7]],
    },
  ];
}

/** The joints of all six legs: left and right of each pair, from the base outward. */
export function legJoints(): InsectJoint[] {
  return legs.flatMap((leg) => {
    const pairs = jointsOf(leg).map(bothSides);
    return [0, 1].flatMap((side) => pairs.map((pair) => pair[side]!));
  });
}
