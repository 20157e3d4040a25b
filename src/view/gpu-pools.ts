import type { CharacterImage } from '../core/character.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import type { ImageTexture } from '../gl/image-texture.ts';
import { Pool } from '../gl/pool.ts';
import type { InfluenceBuffers } from './influence-buffers.ts';
import type { MeshBuffers } from './mesh-buffers.ts';

/**
 * The objects that actors of one character share in a context, which is everything except their
 * posed vertices.
 */
export class GpuPools {
  readonly meshes = new Pool<Mesh, MeshBuffers>();
  readonly influences = new Pool<Skin, InfluenceBuffers>();
  readonly images = new Pool<CharacterImage, ImageTexture>();
}
