import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';

/** Influences that fit in one pair of attributes: vec4 entries, vec4 weights. */
export const lanes = 4;
/** WebGL2 promises 16 attributes: 4 pairs leave room for position and normal. */
export const maximumPairs = 4;

export interface AttributeInfluences {
  /** (vertexCount × pairs × 4) palette entries, padded with 0. */
  readonly entries: Uint16Array;
  /** (vertexCount × pairs × 4) weights, padded with 0. */
  readonly weights: Float32Array;
}

/** The influences of every render vertex in fixed lanes, in the file's order. */
export function packAttributeInfluences(
  mesh: Mesh,
  skin: Skin,
  pairs: number,
): AttributeInfluences {
  const stride = pairs * lanes;
  const entries = new Uint16Array(mesh.vertexCount * stride);
  const weights = new Float32Array(mesh.vertexCount * stride);
  for (let vertex = 0; vertex < mesh.vertexCount; vertex++) {
    const point = mesh.pointOf[vertex]!;
    const from = skin.start[point]!;
    const to = skin.start[point + 1]!;
    entries.set(skin.entries.subarray(from, to), vertex * stride);
    weights.set(skin.weights.subarray(from, to), vertex * stride);
  }
  return { entries, weights };
}

export interface TextureInfluences {
  /** (vertexCount × 2) first texel of each render vertex, and one past its last. */
  readonly ranges: Uint32Array;
  /** (influenceCount × 2) entry and weight of each texel. */
  readonly texels: Float32Array;
}

/** The influences of every render vertex as runs of texels; no limit to their number. */
export function packTextureInfluences(mesh: Mesh, skin: Skin): TextureInfluences {
  const ranges = new Uint32Array(mesh.vertexCount * 2);
  for (let vertex = 0; vertex < mesh.vertexCount; vertex++) {
    const point = mesh.pointOf[vertex]!;
    ranges[vertex * 2] = skin.start[point]!;
    ranges[vertex * 2 + 1] = skin.start[point + 1]!;
  }
  const texels = new Float32Array(skin.weights.length * 2);
  skin.weights.forEach((weight, i) => {
    texels[i * 2] = skin.entries[i]!;
    texels[i * 2 + 1] = weight;
  });
  return { ranges, texels };
}
