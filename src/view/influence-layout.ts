import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import type { Run } from './changed-runs.ts';

/** The number of influences in one pair of attributes: vec4 entries, vec4 weights. */
export const lanes = 4;
/** WebGL2 guarantees 16 attributes, so 4 pairs leave room for position and normal. */
export const maximumPairs = 4;

export interface AttributeInfluences {
  /** (n × pairs × 4) palette entries, padded with 0. */
  readonly entries: Uint16Array;
  /** (n × pairs × 4) weights, padded with 0. */
  readonly weights: Float32Array;
}

/** Packs the influences of a run of n render vertices into fixed lanes, in the file's order. */
export function packAttributeInfluences(
  mesh: Mesh,
  skin: Skin,
  pairs: number,
  { from, to }: Run = { from: 0, to: mesh.vertexCount },
): AttributeInfluences {
  const stride = pairs * lanes;
  const entries = new Uint16Array((to - from) * stride);
  const weights = new Float32Array((to - from) * stride);
  for (let vertex = from; vertex < to; vertex++) {
    const point = mesh.pointOf[vertex]!;
    const end = skin.start[point + 1]!;
    let lane = (vertex - from) * stride;
    for (let i = skin.start[point]!; i < end; i++, lane++) {
      entries[lane] = skin.entries[i]!;
      weights[lane] = skin.weights[i]!;
    }
  }
  return { entries, weights };
}

export interface TextureInfluences {
  /** (vertexCount × 2) the first texel of each render vertex, and one past its last. */
  readonly ranges: Uint32Array;
  /** (influenceCount × 2) entry and weight of each texel. */
  readonly texels: Float32Array;
}

/** Packs the influences of every render vertex into runs of texels, whose number is not limited. */
export function packTextureInfluences(mesh: Mesh, skin: Skin): TextureInfluences {
  const ranges = new Uint32Array(mesh.vertexCount * 2);
  for (let vertex = 0; vertex < mesh.vertexCount; vertex++) {
    const point = mesh.pointOf[vertex]!;
    ranges[vertex * 2] = skin.start[point]!;
    ranges[vertex * 2 + 1] = skin.start[point + 1]!;
  }
  return { ranges, texels: packTexels(skin, { from: 0, to: skin.weights.length }) };
}

/** Returns (n × 2) the entry and weight of each influence in a run of n. */
export function packTexels({ entries, weights }: Skin, { from, to }: Run): Float32Array {
  const texels = new Float32Array((to - from) * 2);
  for (let i = from; i < to; i++) {
    texels[(i - from) * 2] = entries[i]!;
    texels[(i - from) * 2 + 1] = weights[i]!;
  }
  return texels;
}
