import type { Diagnostic } from '../../core/diagnostics.ts';
import {
  type ClipParts,
  isRotationChannel,
  type RotationChannelParts,
  type ScalarChannelParts,
} from '../../core/motion/clip-parts.ts';
import { evaluateRotation, rotationChannelFor } from '../../core/motion/rotation-channel.ts';
import { channelKey } from '../../core/motion/targets.ts';
import { axisDofs } from '../../core/pose.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import type { Written } from '../format.ts';
import { frameTimes } from '../motion/frame-times.ts';
import { sampleAngles } from '../motion/sampled-angles.ts';
import { productOf } from '../motion/turns.ts';
import { AnimLosses } from './anim-losses.ts';
import { plainTangents } from './plain-tangents.ts';
import { writeAnim } from './write-anim.ts';

/**
 * Writes a clip as an `.anim`: the root's translation and three angles of each joint in the order of
 * the file, with the tangents that the format has. It says what became of the others. A skeleton
 * with other joints is refused with an error.
 *
 * @param q (qCount) the values that the clip does not move
 */
export function writeAnimOf(clip: ClipParts, skeleton: Skeleton, q: Float64Array): Written {
  const file = `${clip.name}.anim`;
  const refusal = refusalOf(file, skeleton);
  if (refusal) return { files: [], losses: [refusal] };
  const told = new AnimLosses(file, clip);
  const scalars = new Map<string, ScalarChannelParts>();
  for (const channel of clip.channels) {
    if (!isRotationChannel(channel) && channel.target) {
      scalars.set(channelKey(channel.target), channel);
    }
  }
  for (const channel of clip.channels) {
    if (!isRotationChannel(channel)) continue;
    const angles = anglesOf(channel, skeleton, clip.fps, told);
    if (!angles) return { files: [], losses: [tooLong(file)] };
    for (const each of angles) scalars.set(channelKey(each.target!), each);
  }
  const channels = Array.from({ length: 3 * skeleton.jointCount + 3 }, (_, index) => {
    const target = targetAt(index);
    const own = scalars.get(channelKey(target));
    if (!own) return constant(target, valueOf(skeleton, q, target));
    const plain = plainTangents(own);
    told.curve(plain);
    return plain.channel;
  });
  const bytes = writeAnim({ ...clip, channels });
  return { files: [{ path: file, bytes }], losses: told.losses() };
}

type Target = NonNullable<ScalarChannelParts['target']> & { readonly of: 'value' };

function targetAt(index: number): Target {
  const axis = (index % 3) as 0 | 1 | 2;
  if (index < 3) return { of: 'value', joint: 0, kind: DofKind.slide, axis };
  return { of: 'value', joint: Math.floor(index / 3) - 1, kind: DofKind.hinge, axis };
}

function valueOf(skeleton: Skeleton, q: Float64Array, { joint, kind, axis }: Target): number {
  const dofs = axisDofs(skeleton, skeleton.jointOfSource[joint]!);
  const dof = dofs.find((each) => each.kind === kind && each.axis === axis);
  return dof ? q[dof.index]! : 0;
}

function constant(target: Target, value: number): ScalarChannelParts {
  const key = { time: 0, value, tangentIn: 'flat', tangentOut: 'flat' } as const;
  return { target, before: 'constant', after: 'constant', keys: [key] };
}

/** The angles of a rotation at its keys and at all frames between them; null if too many. */
function anglesOf(
  channel: RotationChannelParts,
  skeleton: Skeleton,
  fps: number,
  told: AnimLosses,
): readonly ScalarChannelParts[] | null {
  const { target, before, after, keys } = channel;
  const product = productOf(skeleton, skeleton.jointOfSource[target.joint] ?? 0)!;
  const times = keys.map(({ time }) => time);
  const sampled = frameTimes([times[0] ?? 0, times.at(-1) ?? 0], fps, times);
  if (!sampled) return null;
  const track = rotationChannelFor(channel);
  const { keys: angles, largest } = sampleAngles(
    (time) => {
      const rotation = new Float64Array(4);
      evaluateRotation(track, time, rotation);
      return rotation;
    },
    sampled,
    product,
  );
  told.rotation(largest);
  return ([0, 1, 2] as const).map((axis) => ({
    target: { of: 'value', joint: target.joint, kind: DofKind.hinge, axis },
    before,
    after,
    keys: angles[axis],
  }));
}

function refusalOf(file: string, skeleton: Skeleton): Diagnostic | null {
  const others = [...skeleton.parents.keys()].filter((joint) => !productOf(skeleton, joint));
  const [first] = others;
  const expected = 'joints that turn about x, y and z by an angle each';
  if (skeleton.jointCount === 0) return refused(file, expected, 'none');
  if (first === undefined) return null;
  const more = others.length > 1 ? ` and ${others.length - 1} more that do not` : '';
  return refused(file, expected, `${skeleton.names[first]!}${more}`);
}

function tooLong(file: string): Diagnostic {
  return refused(file, 'a rotation of fewer frames', 'a longer one');
}

function refused(file: string, expected: string, found: string): Diagnostic {
  const effect = 'no .anim is written; a MOTION.json holds the motion';
  return { severity: 'error', code: 'character/lost', file, expected, found, effect };
}
