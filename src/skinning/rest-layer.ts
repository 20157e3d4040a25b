import type { Character } from '../core/character.ts';
import type { Pose } from '../core/pose.ts';

/** Rows of deltas of some render vertices, times a weight. */
export interface RestTerm {
  readonly weight: number;
  /** (n) render vertices, and (n × 3) what is added to their positions, model units. */
  readonly vertices: Uint32Array;
  readonly offsets: Float32Array;
  /** (m) render vertices, and (m × 3) what is added to their unit normals. */
  readonly normalVertices: Uint32Array;
  readonly normalOffsets: Float32Array;
}

/** A seam: what changes the mesh at rest, before it is skinned. A new one is a file and a line. */
export interface RestLayer {
  readonly id: string;
  /** What its terms are a function of, each compared by identity: an unchanged key costs nothing. */
  key(character: Character, pose: Pose): readonly unknown[];
  /** In the order in which they are added; none where it changes nothing. */
  terms(character: Character, pose: Pose): readonly RestTerm[];
}
