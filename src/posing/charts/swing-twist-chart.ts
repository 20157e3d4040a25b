import { vec3 } from 'gl-matrix';
import type { ChartValues, RotationChart } from './chart.ts';
import { aboutAxis, exponential, fullTurn, nearestShell, product } from './quaternions.ts';

/** Below this the twist, or the direction of the swing, can't be told. */
const least = 1e-14;

/**
 * A twist about the bone, then a swing of the bone: a rotation vector at right angles to it, in two
 * components, both in radians. Where the swing is half a turn, the twist is undefined, and is kept
 * as it was.
 *
 * @param bone its direction in the joint's frame, unit
 */
export function swingTwistChart(bone: readonly [number, number, number]): RotationChart {
  const [first, second] = acrossTo(bone);
  const along = (vector: readonly number[], axis: ArrayLike<number>): number =>
    vector[0]! * axis[0]! + vector[1]! * axis[1]! + vector[2]! * axis[2]!;
  return {
    id: 'swing-twist',
    label: 'Swing and twist',
    names: ['Swing 1', 'Swing 2', 'Twist'],
    read([qx, qy, qz, w], near) {
      const vector = [qx, qy, qz];
      const [x, y, z] = [along(vector, first), along(vector, second), along(vector, bone)];
      const [side, rest] = [Math.hypot(x, y), Math.hypot(z, w)];
      const nearTwist = near[2]!;
      const isDefined = rest > least;
      const twist = isDefined ? 2 * Math.atan2(z, w) : nearTwist;
      // The swing is the rotation without its twist: its axis is turned by half the twist.
      const [sine, cosine] = [Math.sin(twist / 2), Math.cos(twist / 2)];
      const direction =
        side > least ? [(x * cosine - y * sine) / side, (x * sine + y * cosine) / side] : [0, 0];
      const swing = nearestShell(direction, 2 * Math.atan2(side, rest), near.slice(0, 2));
      const turns = Math.round((nearTwist - twist) / fullTurn);
      return [...swing, twist + fullTurn * turns];
    },
    rotationOf([a, b, twist]) {
      const swing = exponential([0, 1, 2].map((i) => a! * first[i]! + b! * second[i]!));
      return product(swing, aboutAxis(bone, twist!));
    },
    stretchAt(values) {
      const swing = swingOf(values);
      return swing < 1e-6 ? 1 : Math.max(1, swing / Math.abs(Math.sin(swing)));
    },
    foldText: (values) =>
      Math.cos(swingOf(values)) < 0
        ? 'The swing is near half a turn: the bone points against its first direction, and its twist means nothing'
        : 'The swing is near a full turn: every direction of the swing gives the same rotation here',
  };
}

function swingOf([a, b]: ChartValues): number {
  return Math.hypot(a!, b!);
}

/** Two unit vectors that are right-handed with the bone; the first is near a coordinate axis. */
function acrossTo(bone: readonly [number, number, number]): [Float64Array, Float64Array] {
  const sizes = bone.map(Math.abs);
  const flattest = sizes.indexOf(Math.min(...sizes));
  const first = Float64Array.from([0, 1, 2], (i) => (i === flattest ? 1 : 0));
  vec3.scaleAndAdd(first, first, bone, -bone[flattest]!);
  vec3.normalize(first, first);
  return [first, vec3.cross(new Float64Array(3), bone, first) as Float64Array];
}
