import type { Vector3 } from '../posing/ik/problem.ts';
import type { ActorId } from './scene.ts';

/** What the IK lab draws over a character, in that character's space. */
export interface IkSketch {
  readonly actorId: ActorId;
  /** The joints of the chain at the step that is shown, from its root to the effector. */
  readonly chain: readonly Vector3[];
  /** The chain at steps before it, the oldest first. */
  readonly earlier: readonly (readonly Vector3[])[];
  readonly target: Vector3;
  /** Half axes of the ellipsoid around the effector that tells how turns can move it. */
  readonly halfAxes: readonly Vector3[];
}
