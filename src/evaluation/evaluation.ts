import type { Bounds } from '../core/bounds.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Pose } from '../core/pose.ts';
import type { Skin } from '../core/skin.ts';
import type { Actor } from '../document/scene.ts';
import type { Pin } from '../posing/pins/pin.ts';
import type { DisplayTransform } from './display-transform.ts';
import type { MethodUse, SkinningMethod, VertexStreams } from '../skinning/method.ts';

/**
 * Revisions tell which stages changed. A stage whose inputs did not change keeps its revision and
 * its arrays, and evaluators of one character whose inputs are equal have the same revision. No
 * revision is ever used again for other inputs.
 */
export interface Revisions {
  /** The revision of `pose` and `characterFromJoint`. */
  readonly pose: number;
  /** The revision of `rest`. */
  readonly rest: number;
  /** The revision of `palette`. */
  readonly palette: number;
  /** The revision of skinned vertices and of `bounds`. */
  readonly vertices: number;
  /**
   * The revision of `vertices`. It is the same as that of skinned vertices unless normals are
   * recomputed from the posed faces.
   */
  readonly normals: number;
  /** The revision of `display`. */
  readonly display: number;
}

/**
 * A character of the scene at one moment, as numbers. This is the only place where a character
 * becomes numbers. Stages are computed when they are first read. The arrays are overwritten at the
 * next moment; `snapshot` makes a copy to keep.
 */
export interface Evaluation {
  readonly state: Actor;
  /** The pose that is shown: the edited pose as the pose layers change it. */
  readonly pose: Required<Pose>;
  /** The pose from which edits start: the shown one without values that are only shown. */
  readonly poseToEdit: Required<Pose>;
  /** The pins as a clip moves them. */
  readonly pins: readonly Pin[];
  /** Where the joints are that its pins follow; see `PoseContext`. */
  readonly followed: Float64Array | null;
  /** (jointCount × 16) column-major, float64: from each joint's frame to character space. */
  readonly characterFromJoint: Float64Array;
  /** The mesh after its rest layers. */
  readonly rest: Mesh;
  readonly skin: Skin;
  /**
   * The method that deforms the mesh. Linear blend replaces a method that is still loading or being
   * prepared.
   */
  readonly method: SkinningMethod;
  /** What the method deforms with, beside the palette. */
  readonly use: MethodUse;
  /** What is still loading, as labels for the user; empty if everything is as the scene says. */
  readonly pending: readonly string[];
  /** (entryCount × vec4sPerEntry × 4) the input of the method's kernel. */
  readonly palette: Float32Array;
  /** The placement of the character in the scene. */
  readonly display: DisplayTransform;
  readonly revisions: Revisions;
  /** Posed positions and normals, computed on the CPU, in character space. */
  vertices(): VertexStreams;
  /**
   * The box of posed vertices and joints, and of the display boxes if there is no mesh, in
   * character space.
   */
  bounds(): Bounds;
  /** Returns a copy of the pose from which edits start, which the caller may keep. */
  snapshot(): Required<Pose>;
  /** Returns an evaluation that stays at this moment until the caller disposes of it. */
  still(): StillEvaluation;
}

/** An evaluation that stays at one moment until it is moved to another one. */
export interface StillEvaluation extends Evaluation {
  /** Moves it to another state of the same actor, at a time of its bound clip in seconds. */
  evaluate(state: Actor, time: number, followed?: Float64Array | null): Evaluation;
  dispose(): void;
}
