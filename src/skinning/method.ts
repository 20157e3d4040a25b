import type { Mesh } from '../core/mesh.ts';
import type { InfluenceRows, Skin } from '../core/skin.ts';

/** Positions and unit normals of render vertices, in the character's space. */
export interface VertexStreams {
  /** (vertexCount × 3) */
  readonly positions: Float32Array;
  /** (vertexCount × 3) */
  readonly normals: Float32Array;
}

/** Where a kernel writes posed vertices. */
export interface PosedStreams {
  /** (vertexCount × 3) */
  readonly positions: Float32Array;
  /** (vertexCount × 3), or null to leave normals out, which takes less time. */
  readonly normals: Float32Array | null;
}

export type MethodId =
  | 'linear-blend'
  | 'rigid'
  | 'dual-quaternion'
  | 'centers-of-rotation'
  | 'delta-mush';

/** A computation: a method combined with a way of normals. */
export type KernelId = MethodId | 'joint-normals';

/**
 * What the WebAssembly kernel does for a method: it blends the first three vec4s of the palette's
 * entries as the rows of a matrix, or the next two as a dual quaternion, and applies the result to
 * points.
 */
export interface WasmPlan {
  /** The influences that are blended, with pairs for dual quaternions; null if it can't. */
  readonly rows: (skin: Skin) => WasmRows | null;
  readonly blend?: 'dual-quaternions';
  /**
   * The centers (pointCount × 3) about which points turn, of what the method prepared. Entries of the
   * palette have a rotation after the rows of the matrix.
   */
  readonly centers?: (extra: unknown) => Float32Array;
  /** Normals are transformed by the cofactors of the matrix, or by one of the next three vec4s. */
  readonly normals: 'cofactors' | 'next-rows';
  /** Moves vertices whose position is not a number; the kernel leaves those that it can't move. */
  readonly complete?: SkinningMethod['deform'];
  /**
   * The method's share, from 0 to 1, in a mixture with what another plan computes from the same
   * palette.
   */
  readonly mixture?: {
    readonly other: WasmPlan;
    share(settings: MethodSettings): number;
  };
}

/**
 * Influences, and for blends of quaternions (pairCount × 2) pairs of palette entries, which their
 * entries count: that of the point's largest weight and the one that influences it. So signs of
 * rotations are found once for each pair and pose.
 */
export interface WasmRows extends InfluenceRows {
  readonly pairs?: Uint16Array;
}

/** A number that a user may set for a method. */
export interface MethodParameter {
  /** Unique among the parameters of all methods; files and the command line use it. */
  readonly name: string;
  readonly label: string;
  /** What it does, as one sentence. */
  readonly help: string;
  readonly least: number;
  readonly most: number;
  readonly step: number;
  readonly initial: number;
}

/** The values of parameters by their names; an absent one has its initial value. */
export type MethodSettings = Readonly<Record<string, number>>;

/** The value of a parameter, within its range. */
export function settingOf(
  settings: MethodSettings,
  { name, least, most, initial }: MethodParameter,
): number {
  return Math.min(most, Math.max(least, settings[name] ?? initial));
}

/** What a method deforms with, beside the palette. */
export interface MethodUse<Extra = unknown> {
  /** What `prepare` computed, or undefined if the method prepares nothing. */
  readonly extra: Extra;
  readonly settings: MethodSettings;
}

/** Every parameter has its initial value. */
export const plainSettings: MethodSettings = {};

/** The use of a method that prepares nothing, with its initial settings. */
export const plainUse: MethodUse<undefined> = { extra: undefined, settings: plainSettings };

/** The rows of methods that blend every influence. */
export function everyInfluence(skin: Skin): InfluenceRows {
  return skin;
}

/**
 * A skinning method. To add one, write one file here, one chunk of GLSL with the same function
 * names and order of operations, and one row in the registry.
 */
export interface SkinningMethod<Id extends KernelId = KernelId, Extra = unknown> {
  readonly id: Id;
  /** Every number of vec4s that a palette entry may have. */
  readonly strides: readonly number[];
  /** The number of vec4s per palette entry of a skin. */
  vec4sPerEntry(skin: Skin): number;
  readonly parameters?: readonly MethodParameter[];
  /**
   * Packs the palette that the vertex kernel reads, rounded once from float64.
   * @param characterFromJoint (jointCount × 16)
   * @param palette (entryCount × vec4sPerEntry × 4) written
   */
  packPalette(skin: Skin, characterFromJoint: Float64Array, palette: Float32Array): void;
  /**
   * Computes once for a skin what does not depend on the pose, such as centers of rotation. It may
   * take long and runs as a task; linear blend stands in until it is done. The result can be cloned.
   * @param onProgress gets the part that is done, from 0 to 1
   */
  prepare?(mesh: Mesh, skin: Skin, onProgress: (part: number) => void): Extra;
  /**
   * The strict kernel: every operation is rounded to float32. It is the definition that the shader
   * must equal.
   * @param mesh after its rest layers; before them if the method has `finish`
   * @param out written for all render vertices
   */
  deform(
    mesh: Mesh,
    skin: Skin,
    palette: Float32Array,
    out: PosedStreams,
    use: MethodUse<Extra>,
  ): void;
  /**
   * Changes the vertices that `deform` posed, for methods that need the whole posed mesh. Such a
   * method is computed on the CPU alone.
   * @param mesh before its rest layers
   * @param rest the mesh after them
   */
  finish?(mesh: Mesh, rest: Mesh, skin: Skin, posed: PosedStreams, use: MethodUse<Extra>): void;
  /**
   * Computes in steps what the first use of a skin would compute at once, for callers that let others
   * work in between.
   */
  warmUp?(mesh: Mesh, skin: Skin, settings: MethodSettings): Iterator<unknown>;
  /** Further attributes of the shader, each (vertexCount × 3). */
  attributes?(mesh: Mesh, extra: Extra): Readonly<Record<string, Float32Array>>;
  /** Further uniforms of the shader. */
  uniforms?(settings: MethodSettings): Readonly<Record<string, number>>;
  /** How the WebAssembly kernel computes the same, or null if it can't. */
  readonly wasm: WasmPlan | null;
  /** The name of the GLSL chunk in shaders/skinning that computes the same. */
  readonly chunk: string;
}
