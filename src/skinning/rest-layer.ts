import type { Character } from '../core/character.ts';
import type { Pose } from '../core/pose.ts';
import type { VertexStreams } from './method.ts';

/** A seam: what changes the mesh at rest, before it is skinned. A new one is a file and a line. */
export interface RestLayer {
  readonly id: string;
  isActive(character: Character, pose: Pose): boolean;
  /** Adds to the positions and normals at rest, which it may write. */
  addTo(character: Character, pose: Pose, rest: VertexStreams): void;
}
