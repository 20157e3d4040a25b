import type { Bounds } from '../core/bounds.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Pose } from '../core/pose.ts';
import type { Skin } from '../core/skin.ts';
import type { Actor } from '../document/scene.ts';
import type { DisplayTransform } from './display-transform.ts';
import type { SkinningMethod, VertexStreams } from '../skinning/method.ts';

/**
 * Tell which stages changed: a stage whose inputs are what they were keeps its revision, and its arrays,
 * and so have evaluators of one character whose inputs are equal the same revision. None is met twice for
 * anything else.
 */
export interface Revisions {
  /** Of `pose` and `characterFromJoint`. */
  readonly pose: number;
  /** Of `rest`. */
  readonly rest: number;
  /** Of `palette`. */
  readonly palette: number;
  /** Of `vertices` and `bounds`. */
  readonly vertices: number;
  /** Of `display`. */
  readonly display: number;
}

/**
 * A character of the scene at a moment, as numbers: the only place where it becomes some. Stages are
 * computed when they are first read. The arrays are written again at the next moment; what is kept
 * beyond it is a copy (`snapshot`).
 */
export interface Evaluation {
  readonly state: Actor;
  /** What is shown: the edited pose under what the pose layers make of it. */
  readonly pose: Pose;
  /** (jointCount × 16) column-major, float64: a joint's frame → character space. */
  readonly characterFromJoint: Float64Array;
  /** The mesh under its rest layers. */
  readonly rest: Mesh;
  readonly skin: Skin;
  /** What deforms it: linear blend stands in for a method whose code is on the way. */
  readonly method: SkinningMethod;
  /** What is on the way, for people; empty where all is as the scene has it. */
  readonly pending: readonly string[];
  /** (entryCount × vec4sPerEntry × 4) what the method's kernel reads. */
  readonly palette: Float32Array;
  /** Where it stands in the scene. */
  readonly display: DisplayTransform;
  readonly revisions: Revisions;
  /** Posed positions and normals, on the CPU; character space. */
  vertices(): VertexStreams;
  /** Of posed vertices and joints, and of boxes where there is no mesh; character space. */
  bounds(): Bounds;
  /** The pose as it is shown, to be kept. */
  snapshot(): Pose;
}
