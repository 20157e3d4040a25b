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

export type MethodId = 'linear-blend' | 'rigid';

/** A computation: a method combined with a way of normals. */
export type KernelId = MethodId | 'joint-normals';

/**
 * What the WebAssembly kernel does for a method: it blends the first three vec4s of the palette's
 * entries as the rows of a matrix and applies it to points.
 */
export interface WasmPlan {
  /** The influences that are blended. */
  readonly rows: (skin: Skin) => InfluenceRows;
  /** Normals are transformed by the cofactors of the matrix, or by one of the next three vec4s. */
  readonly normals: 'cofactors' | 'next-rows';
}

/** The rows of methods that blend every influence. */
export function everyInfluence(skin: Skin): InfluenceRows {
  return skin;
}

/**
 * A skinning method. To add one, write one file here, one chunk of GLSL with the same function
 * names and order of operations, and one row in the registry.
 */
export interface SkinningMethod<Id extends KernelId = KernelId> {
  readonly id: Id;
  /** The number of vec4s per palette entry. */
  readonly vec4sPerEntry: number;
  /**
   * Packs the palette that the vertex kernel reads, rounded once from float64.
   * @param characterFromJoint (jointCount × 16)
   * @param palette (entryCount × vec4sPerEntry × 4) written
   */
  packPalette(skin: Skin, characterFromJoint: Float64Array, palette: Float32Array): void;
  /**
   * The strict kernel: every operation is rounded to float32. It is the definition that the shader
   * must equal.
   * @param out written for all render vertices
   */
  deform(mesh: Mesh, skin: Skin, palette: Float32Array, out: PosedStreams): void;
  /** How the WebAssembly kernel computes the same, or null if it can't. */
  readonly wasm: WasmPlan | null;
  /** The name of the GLSL chunk in shaders/skinning that computes the same. */
  readonly chunk: string;
}
