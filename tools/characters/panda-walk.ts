import { mat4, quat, vec3 } from 'gl-matrix';
import type {
  ScalarChannelParts,
  ScalarClipParts,
  KeyParts,
} from '../../src/core/motion/clip-parts.ts';
import { extractEuler } from '../../src/core/euler.ts';
import { rounded } from './insect/surface.ts';
import type { JointTable } from './joint-table.ts';
import { type BoneMotion, FRAMES_PER_SECOND, type PandaSource } from './panda-source.ts';
import { subtract, type Vector3 } from './vector.ts';

/** A key every second frame; the curves between them are smooth. */
const FRAMES_PER_KEY = 2;

/** How many cycles of the walk the clip shows. */
const CYCLES = 4;

/** A channel that changes less, in meters and radians, has one key. */
const STILL = 1e-4;

/**
 * The panda's walk in place. In the source, hips and shoulders rise and sink each on their own,
 * which joints that only turn cannot do: here a root at the hips rises and pitches, so that it
 * points to the shoulders.
 */
export function pandaWalk({ bones, frames }: PandaSource, table: JointTable): ScalarClipParts {
  const [hips, shoulders] = ['Dummy_hips', 'Dummy_shoulders'];
  const boundPitch = pitch(subtract(bones.get(shoulders)!, bones.get(hips)!));
  const rootAt = (frame: ReadonlyMap<string, BoneMotion>): BoneMotion => {
    const [from, to] = [frame.get(hips)!.place, frame.get(shoulders)!.place];
    const angle = pitch(subtract(to, from)) - boundPitch;
    return { place: from, turn: quat.setAxisAngle(new Float64Array(4), [1, 0, 0], angle) };
  };
  const keyFrames = frames.filter((_, index) => index % FRAMES_PER_KEY === 0);
  const poses = keyFrames.map((frame) => new Map(frame).set('', rootAt(frame)));

  const curves: number[][] = Array.from({ length: 3 + table.bones.length * 3 }, () => []);
  let near = table.bones.map(() => [0, 0, 0]);
  for (const pose of poses) {
    const move = subtract(pose.get('')!.place, bones.get(hips)!);
    near = table.bones.map((bone, joint) => anglesOf(pose, table, bone, joint, near[joint]!));
    for (const [index, value] of [...move, ...near.flat()].entries()) curves[index]!.push(value);
  }
  const period = (frames.length - 1) / FRAMES_PER_SECOND;
  return {
    ...{ file: 'panda_walk.anim', name: 'panda_walk', start: 0, end: CYCLES * period, fps: 30 },
    channels: curves.map(channelOf),
  };
}

/** The angle about x that turns +z to a direction. */
function pitch([, y, z]: Vector3): number {
  return Math.atan2(-y, z);
}

/** The turn of a joint relative to its parent, as angles about x, y and z. */
function anglesOf(
  pose: ReadonlyMap<string, BoneMotion>,
  table: JointTable,
  bone: string,
  joint: number,
  near: readonly number[],
): [number, number, number] {
  const parent = table.bones[table.parents[joint]!];
  const turn = quat.clone(pose.get(bone)!.turn);
  if (parent !== undefined) {
    const back = quat.conjugate(new Float64Array(4), pose.get(parent)!.turn);
    quat.multiply(turn, back, turn);
  }
  const matrix = mat4.fromRotationTranslation(new Float64Array(16), turn, vec3.create());
  return extractEuler(matrix, 'zyx', near);
}

function channelOf(curve: readonly number[]): ScalarChannelParts {
  const values = rounded(curve, 4);
  const isStill = Math.max(...values) - Math.min(...values) < STILL;
  const keys = isStill ? values.slice(0, 1) : values;
  const secondsPerKey = FRAMES_PER_KEY / FRAMES_PER_SECOND;
  const rule = isStill ? 'constant' : 'cycle';
  // Both ends of a cycle have the slope between the keys around them.
  const [slope] = rounded([(values[1]! - values.at(-2)!) / (2 * secondsPerKey)], 4);
  return {
    ...{ target: null, before: rule, after: rule },
    keys: keys.map((value, index): KeyParts => {
      const isEnd = index === 0 || index === keys.length - 1;
      const tangent = isStill ? 'flat' : isEnd ? slope! : 'smooth';
      const [time] = rounded([index * secondsPerKey], 5);
      return { time: time!, value, tangentIn: tangent, tangentOut: tangent };
    }),
  };
}
