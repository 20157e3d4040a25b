import type { CharacterImage } from '../core/character.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import type { ImageTexture } from '../gl/image-texture.ts';
import { Pool } from '../gl/pool.ts';
import type { InfluenceBuffers } from './influence-buffers.ts';
import type { MeshBuffers } from './mesh-buffers.ts';

/** What actors of one character share on a context: all but their posed vertices. */
export class GpuPools {
  readonly meshes = new Pool<Mesh, MeshBuffers>();
  readonly influences = new Pool<Skin, InfluenceBuffers>();
  readonly images = new Pool<CharacterImage, ImageTexture>();
}
