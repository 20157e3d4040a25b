import type { ClipParts } from './motion/clip-parts.ts';
import type { CharacterExtra } from './character.ts';
import type { Place } from './diagnostics.ts';
import type { DofKind } from './skeleton.ts';
import type { SkinnedNormalsId } from './skin.ts';

/**
 * The loose parts of a character, in a form that is easy for a reader to fill. A reader never makes
 * a `Character`: one builder checks, sorts and packs the parts, so that a new format cannot break
 * the invariants of a character.
 */
export interface CharacterParts {
  readonly name: string;
  readonly skeleton?: SkeletonParts;
  readonly mesh?: MeshParts;
  readonly skin?: SkinParts;
  readonly morphs?: readonly MorphParts[];
  readonly clips?: readonly ClipParts[];
  /** Kinds of file that the format has but that were missing, for the user: ".attach". */
  readonly missing: readonly string[];
  /** The handedness of the files' own coordinates; right-handed if absent. */
  readonly fileSpace?: FileSpace;
  /** Names of images that belong to the files but are not needed; none if absent. */
  readonly optionalImages?: readonly string[];
  /** Joints by their file indices; none if absent. */
  readonly rotationLinks?: readonly RotationLink[];
  /** Joints by their file indices; none if absent. */
  readonly ikChains?: readonly IkChain[];
  readonly extra?: CharacterExtra;
}

/** A joint that copies a part of another joint's rotation. */
export interface RotationLink {
  readonly joint: number;
  readonly source: number;
  /** 1 copies the whole rotation. */
  readonly ratio: number;
}

/** A chain of joints with a goal, which the file has for inverse kinematics. */
export interface IkChain {
  /** The joint that the effector is to reach. */
  readonly goal: number;
  readonly effector: number;
  /** The joints that turn, from the one next to the effector upwards. */
  readonly links: readonly number[];
}

/**
 * Sinew is right-handed. A reader mirrors the data of a left-handed file by negating z and
 * reversing the triangles, and writers undo it.
 */
export type FileSpace = 'right-handed' | 'left-handed';

export interface SkeletonParts {
  readonly file: string;
  /** In file order. */
  readonly joints: readonly JointParts[];
}

export interface JointParts {
  /** A unique display name; if the format has no names, its reader makes one. */
  readonly name: string;
  readonly fileName?: string;
  /** The name in English, if the file has one beside the other. */
  readonly englishName?: string;
  /** Where the file names the joint's parent, for messages. */
  readonly place?: Place;
  /** File index of the parent; -1 for a root. */
  readonly parent: number;
  /** In the parent's frame, model units. */
  readonly restOffset: readonly [number, number, number];
  /** Unit quaternion xyzw; identity if absent. */
  readonly restRotation?: readonly [number, number, number, number];
  /** In order of application; the first is the outermost. */
  readonly dofs: readonly DofParts[];
  /** The box that is drawn for the joint: min x y z, max x y z, in the joint's frame. */
  readonly displayBox?: readonly number[];
}

export interface DofParts {
  readonly kind: DofKind;
  /** Unit vector in the joint's frame; not used by a ball. */
  readonly axis: readonly [number, number, number];
  /** One value, or four for a ball; zero (the identity) if absent. */
  readonly rest?: readonly number[];
  /** In radians or model units; unlimited if absent. */
  readonly limits?: readonly [number, number];
}

/**
 * A corner of a triangle refers to a point, and optionally to a texture coordinate and a normal.
 */
export interface MeshParts {
  readonly file: string;
  /** (pointCount × 3) file order, model units. */
  readonly positions: Float32Array;
  /** (triangleCount × 3) indices into `positions`. */
  readonly cornerPoints: Uint32Array;
  /** (n × 2); `cornerUvs` (triangleCount × 3) are indices into it, -1 for a corner without one. */
  readonly uvs?: Float32Array;
  readonly cornerUvs?: Int32Array;
  /**
   * (n × 3); `cornerNormals` (triangleCount × 3) are indices into it, -1 for a corner without one.
   */
  readonly normals?: Float32Array;
  readonly cornerNormals?: Int32Array;
  readonly materials?: readonly MaterialParts[];
  /** Runs of triangles with one material, in order; the whole mesh is one run if absent. */
  readonly submeshes?: readonly { readonly material: string; readonly firstTriangle: number }[];
}

/** Weights in compressed sparse rows, one row per point; joints are given by their file index. */
export interface SkinParts {
  readonly file: string;
  /** (pointCount + 1) */
  readonly start: Uint32Array;
  /**
   * (pointCount) one-based line of each row in the file, for messages; absent if the file has no
   * lines.
   */
  readonly lines?: Uint32Array;
  /** (start[pointCount]) file index of the joint. */
  readonly joints: Uint16Array;
  /** (start[pointCount]) as the file has them. */
  readonly weights: Float32Array;
  /** (jointCount × 16) in file order, column-major; the inverse of the rest pose if absent. */
  readonly jointFromBind?: Float64Array;
  /** (jointCount × 16) the inverses of `jointFromBind`, if the file stores these; for writers. */
  readonly bindFromJoint?: Float64Array;
  /** How the format's own programs transform normals; 'blended' if absent. */
  readonly normals?: SkinnedNormalsId;
}

export interface MaterialParts {
  readonly name: string;
  /** The name of an image file, as the file has it. */
  readonly texture?: string;
  /** Absent if the file has none. */
  readonly colors?: MaterialColors;
  /** An image that is looked up by the normal, and added to the color or multiplied with it. */
  readonly sphere?: { readonly texture: string; readonly blend: 'add' | 'multiply' };
  /** Index of the toon ramp that shades it, or -1 for none. */
  readonly toon?: number;
  /** Whether an outline is drawn. */
  readonly hasEdge?: boolean;
  /** Whether the inner sides are visible too; true if absent. */
  readonly twoSided?: boolean;
}

export type Color = readonly [number, number, number];

/** Colors as the file has them, usually 0 to 1, in the file's (sRGB) encoding. */
export interface MaterialColors {
  readonly diffuse: Color;
  readonly alpha: number;
  readonly specular: Color;
  /** Exponent of the specular highlight. */
  readonly shininess: number;
  readonly ambient: Color;
  /**
   * The color of the surface in full light, by the rule of the format's own program; it may exceed
   * 1.
   */
  readonly shown: Color;
}

/** A morph target: weighted offsets that are added to some points of the mesh at rest. */
export interface MorphParts {
  readonly file: string;
  readonly name: string;
  /** (n) */
  readonly points: Uint32Array;
  /** (n × 3) target − base, model units. */
  readonly offsets: Float32Array;
  /** (m), and (m × 3) offsets of the normals of these points; empty if the file has none. */
  readonly normalPoints: Uint32Array;
  readonly normalOffsets: Float32Array;
}
