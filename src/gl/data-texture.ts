import type { Gpu } from './gpu.ts';
import { Texture, type TextureFormat } from './texture.ts';

const texelSize = { 'data-rgba32f': 4, 'data-rg32f': 2 } as const;
const width = 1024;

/**
 * An array of numbers in a texture, addressed linearly and wrapped into rows of 1,024 texels, which
 * shaders read with `texelFetch(t, ivec2(i & 1023, i >> 10), 0)`.
 */
export class DataTexture {
  readonly texture: Texture;
  private readonly staging: Float32Array;
  private readonly rowLength: number;

  constructor(gpu: Gpu, format: Exclude<TextureFormat, 'color-rgba8'>, texelCount: number) {
    const rows = Math.max(1, Math.ceil(texelCount / width));
    this.texture = new Texture(gpu, format, width, rows);
    this.rowLength = width * texelSize[format];
    this.staging = new Float32Array(rows * this.rowLength);
  }

  /** Writes from the first texel on; whole rows are sent. */
  write(values: ArrayLike<number>): void {
    this.staging.set(values);
    this.texture.write(this.staging, Math.max(1, Math.ceil(values.length / this.rowLength)));
  }

  bind(unit: number): void {
    this.texture.bind(unit);
  }

  dispose(): void {
    this.texture.dispose();
  }
}
