import type { Vector3 } from '../posing/ik/problem.ts';
import type { RotationForm } from '../core/motion/convert-rotation.ts';
import type { ActorId } from './scene.ts';

/** What the rotation lab draws over a character: where the end of a joint's bone goes. */
export interface RotationPaths {
  readonly actorId: ActorId;
  readonly paths: readonly RotationPath[];
}

/** The way of the bone's end over the clip, through the same keys by one kind of curve. */
export interface RotationPath {
  readonly curve: RotationForm;
  /** Whether the clip keeps the rotation by this curve. */
  readonly isStored: boolean;
  /** In the character's space. */
  readonly points: readonly Vector3[];
  /** Where the end is at the keys. */
  readonly keys: readonly Vector3[];
}
