import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';

/** Positions and unit normals of render vertices, character space. */
export interface VertexStreams {
  /** (vertexCount × 3) */
  readonly positions: Float32Array;
  /** (vertexCount × 3) */
  readonly normals: Float32Array;
}

export type MethodId = 'linear-blend' | 'rigid';

/** A method with a way of normals, as it is computed. */
export type KernelId = MethodId | 'joint-normals';

/**
 * A seam: a new skinning method is one file here, one chunk of GLSL with the same function names and
 * order of operations, and one row in the registry.
 */
export interface SkinningMethod<Id extends KernelId = KernelId> {
  readonly id: Id;
  /** How many vec4s of the palette an entry takes. */
  readonly vec4sPerEntry: number;
  /**
   * Packs what the vertex kernel reads, rounded once from float64.
   * @param characterFromJoint (jointCount × 16)
   * @param palette (entryCount × vec4sPerEntry × 4) written
   */
  packPalette(skin: Skin, characterFromJoint: Float64Array, palette: Float32Array): void;
  /**
   * The strict kernel, every operation rounded to float32: the definition that the shader equals.
   * @param out written for all render vertices
   */
  deform(mesh: Mesh, skin: Skin, palette: Float32Array, out: VertexStreams): void;
  /** The chunk under shaders/skinning that computes the same. */
  readonly chunk: string;
}
