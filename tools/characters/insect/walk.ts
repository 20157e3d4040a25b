import { quat, vec3 } from 'gl-matrix';
import type {
  ScalarChannelParts,
  ScalarClipParts,
  KeyParts,
} from '../../../src/core/motion/clip-parts.ts';
import type { Vector3 } from '../vector.ts';
import { footRadius, type Leg, legs, reach } from './legs.ts';
import { anglesOfLeg, type Angles, standing } from './pose.ts';
import { insectJoints } from './parts.ts';
import { rounded } from './surface.ts';

/** The duration of a cycle in seconds, and the distance of the body in it, in model units. */
const period = 0.8;
const stride = 0.46;
const cycles = 5;

const intervals = 16;
/** The fraction of a cycle in which a foot stands. */
const stance = 9 / 16;
const lift = 0.11;

const rootPosition = insectJoints[0]!.position;
const wave = (phase: number, shift = 0): number => Math.sin(2 * Math.PI * (phase + shift));

/**
 * The motion of the body: forward at constant speed, a little up and down twice per cycle, swaying
 * once.
 */
function body(phase: number): { move: Vector3; turn: Vector3 } {
  return {
    move: [0.008 * wave(phase, 0.03), 0.007 * wave(2 * phase, 0.1), stride * phase],
    turn: [0.012 * wave(2 * phase, 0.3), 0.025 * wave(phase, 0.2), 0.02 * wave(phase, 0.55)],
  };
}

/** The position of a foot in the character's space. The legs form two tripods that alternate. */
function footAt(leg: Leg, isRight: boolean, phase: number): Vector3 {
  const isFirst = (legs.indexOf(leg) % 2 === 0) !== isRight;
  const own = phase + (isFirst ? 0 : 0.5);
  const into = own - Math.floor(own);
  const step = Math.floor(own) - (isFirst ? 0 : 0.5);
  // While the foot stands, the body passes over its place.
  const standsAt = leg.foot[2] + stride * (step + stance / 2);
  const swing = Math.max(0, (into - stance) / (1 - stance));
  const eased = swing * swing * swing * (10 - 15 * swing + 6 * swing * swing);
  const raised = 16 * swing * swing * (1 - swing) * (1 - swing);
  const side = isRight ? -1 : 1;
  return [
    side * (leg.foot[0] - 0.03 * raised),
    footRadius + lift * raised,
    standsAt + stride * eased,
  ];
}

/** Maps a point of the character's space to the thorax, relative to its center of rotation. */
function seenFromBody(point: Vector3, phase: number): Vector3 {
  const { move, turn } = body(phase);
  const back = quat.create();
  quat.rotateZ(back, back, turn[2]);
  quat.rotateY(back, back, turn[1]);
  quat.rotateX(back, back, turn[0]);
  quat.conjugate(back, back);
  const local = vec3.fromValues(...point);
  vec3.sub(local, local, vec3.add(vec3.create(), rootPosition, move));
  vec3.transformQuat(local, local, back);
  return [local[0], local[1], local[2]];
}

/** All angles at a phase, in cycles. */
function anglesAt(phase: number): Angles {
  const angles = new Map(standing());
  const sway = (name: string, [x, y, z]: Vector3): void => {
    const [restX, restY, restZ] = angles.get(name) ?? [0, 0, 0];
    angles.set(name, [restX + x, restY + y, restZ + z]);
  };
  for (const leg of legs) {
    for (const isRight of [false, true]) {
      const [x, y, z] = seenFromBody(footAt(leg, isRight, phase), phase);
      const base = leg.base;
      const target: Vector3 = [
        (isRight ? -x : x) - base[0],
        y + rootPosition[1] - base[1],
        z + rootPosition[2] - base[2],
      ];
      for (const [name, turn] of anglesOfLeg(leg, isRight, reach(leg, target))) {
        angles.set(name, turn);
      }
    }
  }
  angles.set('body', body(phase).turn);
  sway('head', [0.02 * wave(2 * phase, 0.5), -0.03 * wave(phase, 0.2), 0]);
  sway('abdomen1', [0.03 * wave(2 * phase), -0.05 * wave(phase, 0.2), 0]);
  sway('abdomen2', [0.02 * wave(2 * phase, -0.12), -0.03 * wave(phase, 0.1), 0]);
  for (const side of [1, -1]) {
    const letter = side > 0 ? 'l' : 'r';
    const shift = side > 0 ? 0 : 0.5;
    const swing = wave(phase, shift);
    sway(`antenna_${letter}_scape`, [0.14 * swing, side * 0.12 * wave(phase, shift + 0.25), 0]);
    sway(`antenna_${letter}_flagellum`, [0.12 * wave(phase, shift - 0.15), 0, 0]);
    sway(`wing_${letter}`, [0, side * 0.03 * wave(phase, 0.2), side * 0.05 * wave(2 * phase, 0.1)]);
    sway(`wing_${letter}_fold`, [0, 0, side * 0.06 * wave(2 * phase, -0.08)]);
  }
  return angles;
}

/**
 * The keys of one cycle. The slopes at both ends are those of the motion, so that cycles join
 * smoothly.
 */
function keysOf(value: (phase: number) => number): KeyParts[] {
  const values = rounded(
    Array.from({ length: intervals + 1 }, (_, key) => value(key / intervals)),
    5,
  );
  const small = 1e-4;
  const [slope] = rounded([(value(small) - value(-small)) / (2 * small * period)], 4);
  const isStill = values.every((each) => Math.abs(each - values[0]!) < 1e-5);
  if (isStill) return [{ time: 0, value: values[0]!, tangentIn: 'flat', tangentOut: 'flat' }];
  return values.map((each, key): KeyParts => {
    const tangent = key === 0 || key === intervals ? slope! : 'smooth';
    const [time] = rounded([(key * period) / intervals], 5);
    return { time: time!, value: each, tangentIn: tangent, tangentOut: tangent };
  });
}

/**
 * The walk: the root's displacement x, y, z and then the angles x, y, z of every joint, in file
 * order.
 */
export function insectWalk(): ScalarClipParts {
  const forward: ScalarChannelParts = {
    target: null,
    before: 'cycle_offset',
    after: 'cycle_offset',
    keys: [0, 1].map((cycle): KeyParts => ({
      time: cycle * period,
      value: cycle * stride,
      tangentIn: 'linear',
      tangentOut: 'linear',
    })),
  };
  const channel = (value: (phase: number) => number): ScalarChannelParts => {
    const keys = keysOf(value);
    const rule = keys.length > 1 ? 'cycle' : 'constant';
    return { target: null, before: rule, after: rule, keys };
  };
  const angles = insectJoints.flatMap(({ name }) =>
    [0, 1, 2].map((axis) => channel((phase) => anglesAt(phase).get(name)?.[axis] ?? 0)),
  );
  return {
    file: 'insect_walk.anim',
    name: 'insect_walk',
    start: 0,
    end: cycles * period,
    fps: 30,
    channels: [
      channel((phase) => body(phase).move[0]),
      channel((phase) => body(phase).move[1]),
      forward,
      ...angles,
    ],
  };
}
