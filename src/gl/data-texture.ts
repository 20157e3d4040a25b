import type { Gpu } from './gpu.ts';
import { Texture, type TextureFormat } from './texture.ts';

const texelSizes = { 'data-rgba32f': 4, 'data-rg32f': 2 } as const;
const width = 1024;

/**
 * An array of numbers in a texture. It is addressed linearly and wrapped into rows of 1,024 texels;
 * shaders read it with `texelFetch(t, ivec2(i & 1023, i >> 10), 0)`.
 */
export class DataTexture {
  readonly texture: Texture;
  private readonly staging: Float32Array;
  private readonly texelSize: number;

  constructor(gpu: Gpu, format: Exclude<TextureFormat, 'color-rgba8'>, texelCount: number) {
    const rows = Math.max(1, Math.ceil(texelCount / width));
    this.texture = new Texture(gpu, format, width, rows);
    this.texelSize = texelSizes[format];
    this.staging = new Float32Array(rows * width * this.texelSize);
  }

  /**
   * Writes values from a texel on. Within one row only those texels are uploaded; beyond it, whole
   * rows.
   */
  write(values: ArrayLike<number>, firstTexel = 0): void {
    const { staging, texelSize } = this;
    const count = values.length / texelSize;
    if (count === 0) return;
    staging.set(values, firstTexel * texelSize);
    const [x, y] = [firstTexel % width, Math.floor(firstTexel / width)];
    const height = Math.ceil((x + count) / width);
    const part = height === 1 ? { x, y, width: count, height } : { x: 0, y, width, height };
    const from = (y * width + part.x) * texelSize;
    const pixels = staging.subarray(from, from + part.width * height * texelSize);
    this.texture.write(pixels, part);
  }

  bind(unit: number): void {
    this.texture.bind(unit);
  }

  dispose(): void {
    this.texture.dispose();
  }
}
