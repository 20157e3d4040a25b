import type { Vector3 } from '../posing/ik/problem.ts';
import type { ActorId } from './scene.ts';

/** A plane through a character, in that character's space. */
export interface CuttingPlane {
  /** A joint, or a place beside it. */
  readonly origin: Vector3;
  /** Unit vectors at right angles; a drawing of the plane has the first to its right. */
  readonly across: Vector3;
  readonly up: Vector3;
  /** Towards who looks at the drawing. */
  readonly normal: Vector3;
  /** How far the bones beside the joint go, in model units. */
  readonly reach: number;
}

/** Which of the three outlines of a cutting figure a line belongs to. */
export type CutRole = 'rigid' | 'blend' | 'third';

/** What the cutting figure draws over a character, in that character's space. */
export interface CutSketch {
  readonly actorId: ActorId;
  readonly plane: CuttingPlane;
  readonly lines: readonly { readonly role: CutRole; readonly points: readonly Vector3[] }[];
}
