import type { Character } from '../core/character.ts';
import type { Pose } from '../core/pose.ts';

/** Sparse offsets for some render vertices, with a weight. */
export interface RestTerm {
  readonly weight: number;
  /** (n) render vertices, and (n × 3) offsets of their positions, in model units. */
  readonly vertices: Uint32Array;
  readonly offsets: Float32Array;
  /** (m) render vertices, and (m × 3) offsets of their unit normals. */
  readonly normalVertices: Uint32Array;
  readonly normalOffsets: Float32Array;
}

/**
 * A change of the mesh at rest, before skinning. To add one, write a file and add a line to
 * rest-mesh.ts.
 */
export interface RestLayer {
  readonly id: string;
  /**
   * The inputs of the terms, compared by identity: nothing is recomputed while they are unchanged.
   */
  key(character: Character, pose: Pose): readonly unknown[];
  /** The terms, in the order in which they are added; empty if nothing changes. */
  terms(character: Character, pose: Pose): readonly RestTerm[];
}
