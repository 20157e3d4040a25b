import type { Character, CharacterImage } from '../core/character.ts';
import { type Gpu, GpuLimitError } from '../gl/gpu.ts';
import { ImageTexture } from '../gl/image-texture.ts';
import type { Lease } from '../gl/pool.ts';
import type { GpuPools } from './gpu-pools.ts';
import { decodeImage } from './decode-image.ts';

/** Tells that a picture came, or why it can't be shown. */
export type OnImage = (image: CharacterImage, fault: string | null) => void;

/**
 * The textures of a character's materials, shared with its copies; each is there once its picture is
 * decoded, at once where a copy shows it already.
 */
export class SurfaceTextures {
  private readonly gpu: Gpu;
  private readonly pool: GpuPools['images'];
  private readonly onImage: OnImage;
  private readonly textures = new Map<string, Lease<ImageTexture>>();
  private disposed = false;

  constructor(gpu: Gpu, { images: pool }: GpuPools, { images }: Character, onImage: OnImage) {
    this.gpu = gpu;
    this.pool = pool;
    this.onImage = onImage;
    for (const image of images) {
      if (pool.has(image)) this.textures.set(image.name, pool.lease(image, never));
      else this.load(image).catch(reportError);
    }
  }

  /** @param name as the character's images have it */
  find(name: string | undefined): ImageTexture | undefined {
    return name === undefined ? undefined : this.textures.get(name)?.value;
  }

  dispose(): void {
    this.disposed = true;
    for (const texture of this.textures.values()) texture.release();
  }

  private async load(image: CharacterImage): Promise<void> {
    const picture = await decodeImage(image);
    if (this.disposed) return;
    if (typeof picture === 'string') {
      this.onImage(image, picture);
      return;
    }
    try {
      const texture = this.pool.lease(image, () => new ImageTexture(this.gpu, picture));
      this.textures.set(image.name, texture);
      this.onImage(image, null);
    } catch (error) {
      if (!(error instanceof GpuLimitError)) throw error;
      this.onImage(image, error.message);
    }
  }
}

function never(): never {
  throw new Error('the pool has the texture');
}
