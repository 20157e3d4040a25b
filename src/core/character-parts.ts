import type { CharacterExtra } from './character.ts';
import type { Place } from './diagnostics.ts';
import type { DofKind } from './skeleton.ts';
import type { NormalsId } from './skin.ts';

/**
 * Loose parts, pleasant for a reader to fill. A reader never makes a `Character`: one builder
 * checks, sorts and packs these, so that a new format cannot break an invariant further down.
 */
export interface CharacterParts {
  readonly name: string;
  readonly skeleton?: SkeletonParts;
  readonly mesh?: MeshParts;
  readonly skin?: SkinParts;
  readonly morphs?: readonly MorphParts[];
  readonly clips?: readonly ClipParts[];
  /** Kinds of file that the format has and that were not there, for the user: ".attach". */
  readonly missing: readonly string[];
  /** Of the files' own coordinates; right-handed where absent. */
  readonly fileSpace?: FileSpace;
  /** Names of images that go with the files and may stay away; none where absent. */
  readonly optionalImages?: readonly string[];
  readonly extra?: CharacterExtra;
}

/**
 * Sinew is right-handed. What a left-handed file has was mirrored when it was read, z negated and
 * triangles turned round; writers undo it.
 */
export type FileSpace = 'right-handed' | 'left-handed';

export interface SkeletonParts {
  readonly file: string;
  /** In file order. */
  readonly joints: readonly JointParts[];
}

export interface JointParts {
  /** Unique display name; where the format is nameless its reader makes one. */
  readonly name: string;
  readonly fileName?: string;
  /** Of its parent in the file, for messages. */
  readonly place?: Place;
  /** File index of the parent; -1 for a root. */
  readonly parent: number;
  /** In the parent's frame, model units. */
  readonly restOffset: readonly [number, number, number];
  /** Unit quaternion xyzw; identity where absent. */
  readonly restRotation?: readonly [number, number, number, number];
  /** In order of application: the first is outermost. */
  readonly dofs: readonly DofParts[];
  /** Corners of the box that stands for the joint: min x y z, max x y z, joint frame. */
  readonly displayBox?: readonly number[];
}

export interface DofParts {
  readonly kind: DofKind;
  /** Unit, joint frame; unused by a ball. */
  readonly axis: readonly [number, number, number];
  /** One value, or four of a ball; zero (the identity) where absent. */
  readonly rest?: readonly number[];
  /** Radians or model units; unlimited where absent. */
  readonly limits?: readonly [number, number];
}

/** A corner of a triangle names a point, and perhaps a texture coordinate and a normal. */
export interface MeshParts {
  readonly file: string;
  /** (pointCount × 3) file order, model units. */
  readonly positions: Float32Array;
  /** (triangleCount × 3) index into `positions`. */
  readonly cornerPoints: Uint32Array;
  /** (n × 2), with `cornerUvs` (triangleCount × 3) into it; -1 where a corner has none. */
  readonly uvs?: Float32Array;
  readonly cornerUvs?: Int32Array;
  /** (n × 3), with `cornerNormals` (triangleCount × 3) into it; -1 where a corner has none. */
  readonly normals?: Float32Array;
  readonly cornerNormals?: Int32Array;
  readonly materials?: readonly MaterialParts[];
  /** Runs of triangles of one material, in order; the whole mesh where absent. */
  readonly submeshes?: readonly { readonly material: string; readonly firstTriangle: number }[];
}

/** Weights in compressed sparse rows, a row a point; joints by file index. */
export interface SkinParts {
  readonly file: string;
  /** (pointCount + 1) */
  readonly start: Uint32Array;
  /** (pointCount) one-based line of each row in the file, for messages; absent where it has none. */
  readonly lines?: Uint32Array;
  /** (start[pointCount]) file index of the joint. */
  readonly joints: Uint16Array;
  /** (start[pointCount]) as the file has them. */
  readonly weights: Float32Array;
  /** (jointCount × 16) file order, column-major; the inverse of the rest pose where absent. */
  readonly jointFromBind?: Float64Array;
  /** (jointCount × 16) their inverses, where it is these that the file has: for writers. */
  readonly bindFromJoint?: Float64Array;
  /** How the format's own programs turn normals; 'blended' where absent. */
  readonly normals?: NormalsId;
}

export interface MaterialParts {
  readonly name: string;
  /** Name of an image file, as the file has it. */
  readonly texture?: string;
  /** Absent where the file has none. */
  readonly colors?: MaterialColors;
  /** An image that the normal looks up, added to the color or multiplied with it. */
  readonly sphere?: { readonly texture: string; readonly blend: 'add' | 'multiply' };
  /** Index of the ramp that shades it, or -1 for none. */
  readonly toon?: number;
  /** Whether an outline is drawn. */
  readonly hasEdge?: boolean;
  /** Whether the inner sides are shown too; they are where absent. */
  readonly twoSided?: boolean;
}

export type Color = readonly [number, number, number];

/** As the file has them, 0 to 1 as a rule, in the file's (sRGB) encoding. */
export interface MaterialColors {
  readonly diffuse: Color;
  readonly alpha: number;
  readonly specular: Color;
  /** Exponent of the highlight. */
  readonly shininess: number;
  readonly ambient: Color;
  /** What the surface shows in full light, by the rule of the format's own program; it may pass 1. */
  readonly shown: Color;
}

/** A shape that is added, by a weight, to the mesh at rest: offsets of some of its points. */
export interface MorphParts {
  readonly file: string;
  readonly name: string;
  /** (n) */
  readonly points: Uint32Array;
  /** (n × 3) target − base, model units. */
  readonly offsets: Float32Array;
  /** (m), and (m × 3) offsets of their normals; empty where the file has none. */
  readonly normalPoints: Uint32Array;
  readonly normalOffsets: Float32Array;
}

/** An animation: curves for some of the degrees of freedom. */
export interface ClipParts {
  readonly file: string;
  readonly name: string;
  /** Seconds; the range that is played, whatever the keys' times. */
  readonly start: number;
  readonly end: number;
  readonly channels: readonly ChannelParts[];
}

/** What a curve does outside its keys. */
export type Extrapolation = 'constant' | 'linear' | 'cycle' | 'cycle_offset' | 'bounce';

/** The slope at a key: by rule, or as it is. */
export type Tangent = 'flat' | 'linear' | 'smooth' | number;

export interface ChannelParts {
  /** What it moves, or null where the skeleton has no such thing. */
  readonly target: {
    /** File index. */
    readonly joint: number;
    readonly kind: DofKind;
    readonly axis: 0 | 1 | 2;
  } | null;
  readonly before: Extrapolation;
  readonly after: Extrapolation;
  readonly keys: readonly KeyParts[];
}

export interface KeyParts {
  /** Seconds. */
  readonly time: number;
  readonly value: number;
  readonly tangentIn: Tangent;
  readonly tangentOut: Tangent;
}
