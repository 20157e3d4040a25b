import { bonesOf } from '../../core/bones.ts';
import type { Character } from '../../core/character.ts';
import { chainProblem, slidesOf } from './chain-problem.ts';
import type { Vector3 } from './problem.ts';

/**
 * The point of a joint, in its frame, that a handle or keys move: its origin, or else the end of its
 * bone, if the chain can't move the origin because the joint itself begins the chain.
 *
 * @param q (qCount) the pose
 * @param count how many joints the chain has
 */
export function aimedPoint(
  character: Character,
  q: Float64Array,
  joint: number,
  count: number,
): Vector3 {
  const { skeleton } = character;
  const origin = [0, 0, 0] as const;
  if (count === 1 && slidesOf(skeleton, joint).length > 0) return origin;
  const parts = { skeleton, q, joint, point: origin, count, held: [], natures: [] };
  // Files put several joints at one place, between which there is no length.
  if (chainProblem(parts).reach > 1e-6) return origin;
  return bonesOf(character).find((bone) => bone.joint === joint)?.vector ?? origin;
}
