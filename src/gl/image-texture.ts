import { type Gpu, GpuLimitError } from './gpu.ts';

/** A picture for surfaces in sRGB, which is filtered, has mipmaps and repeats beyond its edges. */
export class ImageTexture {
  private readonly gl: WebGL2RenderingContext;
  private readonly handle: WebGLTexture;
  private readonly untrack: () => void;

  /** @param image has its first row at the bottom, v = 0 */
  constructor(gpu: Gpu, image: ImageBitmap | ImageData) {
    const { gl } = gpu;
    const { width, height } = image;
    if (Math.max(width, height) > gpu.maxTextureSize) {
      const limit = gpu.maxTextureSize;
      throw new GpuLimitError(`the GPU takes textures up to ${limit}, not ${width} × ${height}`);
    }
    this.gl = gl;
    this.handle = gl.createTexture();
    this.untrack = gpu.track('texture');
    gl.bindTexture(gl.TEXTURE_2D, this.handle);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, image);
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.REPEAT);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.REPEAT);
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
}
