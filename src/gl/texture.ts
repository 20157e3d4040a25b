import { type Gpu, GpuLimitError } from './gpu.ts';

/**
 * The `data` formats hold exact numbers and are read by texel; the `color` formats are filtered.
 */
export type TextureFormat = 'data-rgba32f' | 'data-rg32f' | 'color-rgba8';

export interface TexelRectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** A two-dimensional texture. Whoever creates it owns it. */
export class Texture {
  readonly handle: WebGLTexture;
  readonly width: number;
  readonly height: number;
  private readonly gl: WebGL2RenderingContext;
  private readonly format: TextureFormat;
  private readonly untrack: () => void;

  constructor(gpu: Gpu, format: TextureFormat, width: number, height: number) {
    if (width > gpu.maxTextureSize || height > gpu.maxTextureSize) {
      const limit = gpu.maxTextureSize;
      throw new GpuLimitError(`the GPU takes textures up to ${limit}, not ${width} × ${height}`);
    }
    const { gl } = gpu;
    this.gl = gl;
    this.format = format;
    this.width = width;
    this.height = height;
    this.handle = gl.createTexture();
    this.untrack = gpu.track('texture');
    gl.bindTexture(gl.TEXTURE_2D, this.handle);
    gl.texStorage2D(gl.TEXTURE_2D, 1, this.constants.internal, width, height);
    const filter = format === 'color-rgba8' ? gl.LINEAR : gl.NEAREST;
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    gl.bindTexture(gl.TEXTURE_2D, null);
  }

  /** Writes a rectangle of texels, row by row. */
  write(pixels: Float32Array, { x, y, width, height }: TexelRectangle): void {
    const { gl } = this;
    const { layout, type } = this.constants;
    gl.bindTexture(gl.TEXTURE_2D, this.handle);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, x, y, width, height, layout, type, pixels);
    gl.bindTexture(gl.TEXTURE_2D, null);
  }

  bind(unit: number): void {
    this.gl.activeTexture(this.gl.TEXTURE0 + unit);
    this.gl.bindTexture(this.gl.TEXTURE_2D, this.handle);
  }

  dispose(): void {
    this.gl.deleteTexture(this.handle);
    this.untrack();
  }

  private get constants(): { internal: number; layout: number; type: number } {
    const { gl } = this;
    switch (this.format) {
      case 'data-rgba32f':
        return { internal: gl.RGBA32F, layout: gl.RGBA, type: gl.FLOAT };
      case 'data-rg32f':
        return { internal: gl.RG32F, layout: gl.RG, type: gl.FLOAT };
      case 'color-rgba8':
        return { internal: gl.RGBA8, layout: gl.RGBA, type: gl.UNSIGNED_BYTE };
    }
  }
}
