import { vec3 } from 'gl-matrix';
import { bonesOf } from '../../core/bones.ts';
import type { ClipParts } from '../../core/motion/clip-parts.ts';
import type { RotationPath } from '../../document/rotation-paths.ts';
import { EvaluationPool } from '../../evaluation/evaluation-pool.ts';
import { Evaluator } from '../../evaluation/evaluator.ts';
import type { Kernels } from '../../evaluation/kernels.ts';
import type { Vector3 } from '../../posing/ik/problem.ts';
import type { Conversion } from './conversions.ts';
import type { Subject } from './subject.ts';

/** Points of a path a second, and the least and the most of them in all. */
const [rate, fewest, most] = [60, 96, 600];

/**
 * Returns where the end of the joint's bone goes by each kind of curve. The other joints move as the
 * clip moves them. Pins hold nothing, and edits that are not keyed do not count, so that the paths
 * show what the curves do. There are no paths as long as the code that plays clips is loading.
 *
 * @param kernels reading subscribes to what they load
 */
export function endPaths(
  { actor, joint, clip, motion }: Subject,
  conversions: readonly Conversion[],
  kernels: Kernels,
): readonly RotationPath[] {
  const moved = { ...actor, clip: 0, pins: [], unkeyed: null };
  const evaluator = new Evaluator(moved, new EvaluationPool(kernels));
  if (evaluator.pending.length > 0) return [];
  const bone = bonesOf(actor.character).find((each) => each.joint === joint);
  const end = bone?.vector ?? [0, 0, 0];
  const through = (played: ClipParts, times: readonly number[]): Vector3[] =>
    times.map((time) => {
      const { characterFromJoint } = evaluator.evaluate({ ...moved, clips: [played] }, time);
      const matrix = characterFromJoint.subarray(joint * 16, joint * 16 + 16);
      const [x, y, z] = vec3.transformMat4(new Float64Array(3), end, matrix);
      return [x!, y!, z!];
    });
  const keys = motion.keys.filter((time) => time >= clip.start && time <= clip.end);
  const times = [...new Set([...evenly(clip), ...keys])].sort((a, b) => a - b);
  const paths = conversions.flatMap(({ curve, isStored, converted }): RotationPath[] =>
    converted
      ? [{ curve, isStored, points: through(converted, times), keys: through(converted, keys) }]
      : [],
  );
  evaluator.dispose();
  return paths;
}

function evenly({ start, end }: ClipParts): number[] {
  const count = Math.min(Math.max(Math.ceil((end - start) * rate), fewest), most);
  return Array.from({ length: count + 1 }, (_, i) => start + ((end - start) * i) / count);
}
