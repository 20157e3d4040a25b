import type { CharacterImage } from '../../core/character.ts';

/** An image in the form that the GPU takes, with its first row at the bottom. */
export type Picture = ImageBitmap | ImageData;

/** Decodes an image, or returns the reason why it can't be shown. */
type Decode = (image: CharacterImage) => Promise<Picture | string>;

const bytesPerPixel = 4;

/**
 * Keeps decoded pictures for views that are created again. The history may hold many characters, so
 * beyond a limit of bytes, the least recently used pictures are dropped and decoded again when
 * needed.
 */
export class DecodedImages {
  private readonly decode: Decode;
  private readonly byteLimit: number;
  /** The least recently used picture comes first. */
  private readonly kept = new Map<CharacterImage, Picture>();
  private readonly pending = new Map<CharacterImage, Promise<Picture | string>>();
  private keptBytes = 0;

  constructor(decode: Decode, byteLimit: number) {
    this.decode = decode;
    this.byteLimit = byteLimit;
  }

  /** Returns the picture if it is kept. */
  find(image: CharacterImage): Picture | undefined {
    const picture = this.kept.get(image);
    if (picture) {
      this.kept.delete(image);
      this.kept.set(image, picture);
    }
    return picture;
  }

  /**
   * Returns the picture, or the reason why it can't be shown. Requests at the same time share the
   * work.
   */
  async load(image: CharacterImage): Promise<Picture | string> {
    const known = this.find(image) ?? this.pending.get(image);
    if (known) return known;
    const decoding = this.decode(image);
    this.pending.set(image, decoding);
    try {
      const picture = await decoding;
      if (typeof picture !== 'string') this.keep(image, picture);
      return picture;
    } finally {
      this.pending.delete(image);
    }
  }

  private keep(image: CharacterImage, picture: Picture): void {
    this.kept.set(image, picture);
    this.keptBytes += bytesOf(picture);
    for (const [oldest, { width, height }] of this.kept) {
      if (this.keptBytes <= this.byteLimit) return;
      this.kept.delete(oldest);
      this.keptBytes -= bytesOf({ width, height });
    }
  }
}

function bytesOf({ width, height }: Pick<Picture, 'width' | 'height'>): number {
  return width * height * bytesPerPixel;
}
