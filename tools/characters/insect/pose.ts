import { subtract, type Vector3 } from '../vector.ts';
import { footRadius, type Leg, type LegAngles, legs, reach } from './legs.ts';

/** The angles x, y, z of joints by name, in radians; joints that are not named have zeros. */
export type Angles = ReadonlyMap<string, Vector3>;

/** The angles of a leg's joints; those of a right leg have the opposite sign. */
export function anglesOfLeg(leg: Leg, isRight: boolean, angles: LegAngles): [string, Vector3][] {
  const name = isRight ? leg.name.replace('_l', '_r') : leg.name;
  const sign = isRight ? -1 : 1;
  return [
    [`${name}_coxa`, [0, sign * angles.coxa, 0]],
    [`${name}_femur`, [0, 0, sign * angles.femur]],
    [`${name}_tibia`, [0, 0, sign * angles.tibia]],
    [`${name}_tarsus`, [0, 0, sign * angles.tarsus]],
  ];
}

/** The mirrored angles of the joints on both sides. */
function pair(name: string, [x, y, z]: Vector3): [string, Vector3][] {
  return [
    [name, [x, y, z]],
    [name.replace('_l', '_r'), [x, -y, -z]],
  ];
}

/** The standing pose: feet on the floor, wings laid back, abdomen and antennae relaxed. */
export function standing(): Angles {
  const feet = legs.flatMap((leg) => {
    const [x, , z] = subtract(leg.foot, leg.base);
    const angles = reach(leg, [x, footRadius - leg.base[1], z]);
    return [false, true].flatMap((isRight) => anglesOfLeg(leg, isRight, angles));
  });
  return new Map([
    ...feet,
    ['head', [0.12, 0, 0]],
    ['abdomen1', [0.1, 0, 0]],
    ['abdomen2', [-0.12, 0, 0]],
    ['abdomen3', [-0.16, 0, 0]],
    ...pair('wing_l', [-0.1, 0.95, 0.2]),
    ...pair('wing_l_fold', [0, 0, -0.12]),
    ...pair('antenna_l_scape', [0.1, 0.1, 0]),
    ...pair('antenna_l_flagellum', [-0.1, 0.05, 0]),
  ]);
}
