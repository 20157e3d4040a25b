import type { CharacterImage } from '../../core/character.ts';
import { type Gpu, GpuLimitError } from '../../gl/gpu.ts';
import { ImageTexture } from '../../gl/image-texture.ts';
import type { Lease } from '../../gl/pool.ts';
import type { GpuPools } from '../gpu-pools.ts';
import { decodedImages } from './decode-image.ts';
import type { OnImage } from '../lazy-dress.ts';
import type { Picture } from './decoded-images.ts';

/**
 * The textures of images, which actors with the same ones share. Each is available when
 * its picture is decoded, or immediately if a copy shows it already or the decoded picture is kept.
 */
export class SurfaceTextures {
  private readonly gpu: Gpu;
  private readonly pool: GpuPools['images'];
  private readonly onImage: OnImage;
  private readonly textures = new Map<string, Lease<ImageTexture>>();
  /** Settles when all pictures are decoded and, where possible, are in textures. */
  readonly loaded: Promise<unknown>;
  private disposed = false;

  constructor(
    gpu: Gpu,
    { images: pool }: GpuPools,
    images: readonly CharacterImage[],
    onImage: OnImage,
  ) {
    this.gpu = gpu;
    this.pool = pool;
    this.onImage = onImage;
    const loads = images.flatMap((image) => this.show(image) ?? []);
    this.loaded = Promise.all(loads.map((load) => load.catch(reportError)));
  }

  /** @param name the name in the character's images */
  find(name: string | undefined): ImageTexture | undefined {
    return name === undefined ? undefined : this.textures.get(name)?.value;
  }

  dispose(): void {
    this.disposed = true;
    for (const texture of this.textures.values()) texture.release();
  }

  /** Shows the image immediately if possible, and otherwise returns a promise. */
  private show(image: CharacterImage): Promise<void> | null {
    const picture = decodedImages.find(image);
    if (this.pool.has(image)) this.add(image, never);
    else if (picture) this.create(image, picture);
    else return this.load(image);
    return null;
  }

  private async load(image: CharacterImage): Promise<void> {
    const picture = await decodedImages.load(image);
    if (this.disposed) return;
    if (typeof picture === 'string') this.onImage(image.name, picture);
    else if (this.create(image, picture)) this.onImage(image.name, null);
  }

  /** Returns whether the GPU accepts the texture. */
  private create(image: CharacterImage, picture: Picture): boolean {
    try {
      this.add(image, () => new ImageTexture(this.gpu, picture));
      return true;
    } catch (error) {
      if (!(error instanceof GpuLimitError)) throw error;
      this.onImage(image.name, error.message);
      return false;
    }
  }

  private add(image: CharacterImage, create: () => ImageTexture): void {
    this.textures.set(image.name, this.pool.lease(image, create));
  }
}

function never(): never {
  throw new Error('the pool has the texture');
}
