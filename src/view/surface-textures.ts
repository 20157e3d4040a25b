import type { Character, CharacterImage } from '../core/character.ts';
import { type Gpu, GpuLimitError } from '../gl/gpu.ts';
import { ImageTexture } from '../gl/image-texture.ts';
import { decodeImage } from './decode-image.ts';

/** Tells that a picture came, or why it can't be shown. */
export type OnImage = (image: CharacterImage, fault: string | null) => void;

/** The textures of a character's materials; each is there once its picture is decoded. */
export class SurfaceTextures {
  private readonly gpu: Gpu;
  private readonly onImage: OnImage;
  private readonly textures = new Map<string, ImageTexture>();
  private disposed = false;

  constructor(gpu: Gpu, { images }: Character, onImage: OnImage) {
    this.gpu = gpu;
    this.onImage = onImage;
    for (const image of images) void this.load(image);
  }

  /** @param name as the character's images have it */
  find(name: string | undefined): ImageTexture | undefined {
    return name === undefined ? undefined : this.textures.get(name);
  }

  dispose(): void {
    this.disposed = true;
    for (const texture of this.textures.values()) texture.dispose();
  }

  private async load(image: CharacterImage): Promise<void> {
    const picture = await decodeImage(image);
    if (this.disposed) return;
    if (typeof picture === 'string') {
      this.onImage(image, picture);
      return;
    }
    try {
      this.textures.set(image.name, new ImageTexture(this.gpu, picture));
      this.onImage(image, null);
    } catch (error) {
      if (!(error instanceof GpuLimitError)) throw error;
      this.onImage(image, error.message);
    }
  }
}
