import type { Mesh } from '../core/mesh.ts';
import { largestInfluenceCount, type Skin } from '../core/skin.ts';
import { Buffer } from '../gl/buffer.ts';
import { DataTexture } from '../gl/data-texture.ts';
import type { Gpu } from '../gl/gpu.ts';
import { Owner } from '../gl/owner.ts';
import type { Attribute } from '../gl/vertex-array.ts';
import { changedInfluences, changedVertices } from './changed-runs.ts';
import {
  lanes,
  maximumPairs,
  packAttributeInfluences,
  packTexels,
  packTextureInfluences,
} from './influence-layout.ts';

/** All influences of a skin on the GPU, in one of two layouts. */
export interface InfluenceBuffers {
  /** The number of attribute pairs, or 0 if the influences are in the texture. */
  readonly pairs: number;
  readonly attributes: Readonly<Record<string, Attribute>>;
  readonly texture: DataTexture | null;
  /**
   * Replaces the skin that it holds with another by uploading the bytes that differ. It returns
   * false if rows have other lengths, so that everything must be created again.
   */
  patch(held: Skin, skin: Skin): boolean;
  dispose(): void;
}

/** What each of the layouts creates. */
type Layout = Omit<InfluenceBuffers, 'patch' | 'dispose'> & {
  readonly write: (held: Skin, skin: Skin) => void;
};

export function createInfluenceBuffers(
  gpu: Gpu,
  mesh: Mesh,
  skin: Skin,
  forceTexture = false,
): InfluenceBuffers {
  const pairs = Math.max(1, Math.ceil(largestInfluenceCount(skin) / lanes));
  // The owner disposes of what was created, also if a later part can't be created.
  const owner = new Owner();
  try {
    const { write, ...made } =
      pairs > maximumPairs || forceTexture
        ? createTexture(owner, gpu, mesh, skin)
        : createAttributes(owner, gpu, mesh, skin, pairs);
    return {
      ...made,
      patch(held, other) {
        if (held.start !== other.start) return false;
        write(held, other);
        return true;
      },
      dispose: () => owner.dispose(),
    };
  } catch (error) {
    owner.dispose();
    throw error;
  }
}

function createAttributes(owner: Owner, gpu: Gpu, mesh: Mesh, skin: Skin, pairs: number): Layout {
  const { entries, weights } = packAttributeInfluences(mesh, skin, pairs);
  const entryBuffer = owner.own(new Buffer(gpu, 'vertex', entries));
  const weightBuffer = owner.own(new Buffer(gpu, 'vertex', weights));
  const attributes: Record<string, Attribute> = {};
  for (let pair = 0; pair < pairs; pair++) {
    attributes[`entries${pair}`] = {
      buffer: entryBuffer,
      size: 4,
      type: 'uint16',
      stride: pairs * lanes * Uint16Array.BYTES_PER_ELEMENT,
      offset: pair * lanes * Uint16Array.BYTES_PER_ELEMENT,
    };
    attributes[`weights${pair}`] = {
      buffer: weightBuffer,
      size: 4,
      stride: pairs * lanes * Float32Array.BYTES_PER_ELEMENT,
      offset: pair * lanes * Float32Array.BYTES_PER_ELEMENT,
    };
  }
  return { pairs, attributes, texture: null, write };

  function write(held: Skin, other: Skin): void {
    for (const run of changedVertices(mesh, held, other)) {
      const packed = packAttributeInfluences(mesh, other, pairs, run);
      const first = run.from * pairs * lanes;
      weightBuffer.write(packed.weights, first * Float32Array.BYTES_PER_ELEMENT);
      if (held.entries === other.entries) continue;
      entryBuffer.write(packed.entries, first * Uint16Array.BYTES_PER_ELEMENT);
    }
  }
}

function createTexture(owner: Owner, gpu: Gpu, mesh: Mesh, skin: Skin): Layout {
  const { ranges, texels } = packTextureInfluences(mesh, skin);
  const texture = owner.own(new DataTexture(gpu, 'data-rg32f', texels.length / 2));
  texture.write(texels);
  const buffer = owner.own(new Buffer(gpu, 'vertex', ranges));
  return {
    pairs: 0,
    attributes: { influenceRange: { buffer, size: 2, type: 'uint32' } },
    texture,
    write(held, other) {
      for (const run of changedInfluences(held, other)) {
        texture.write(packTexels(other, run), run.from);
      }
    },
  };
}
