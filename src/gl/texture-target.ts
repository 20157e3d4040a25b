import type { Gpu } from './gpu.ts';
import { Texture } from './texture.ts';

/** A color texture that can be drawn into; shadows and their blur use it. */
export class TextureTarget {
  readonly texture: Texture;
  private readonly gl: WebGL2RenderingContext;
  private readonly handle: WebGLFramebuffer;
  private readonly untrack: () => void;

  constructor(gpu: Gpu, width: number, height: number) {
    const { gl } = gpu;
    this.gl = gl;
    this.texture = new Texture(gpu, 'color-rgba8', width, height);
    this.handle = gl.createFramebuffer();
    this.untrack = gpu.track('framebuffer');
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.handle);
    const { COLOR_ATTACHMENT0: color, TEXTURE_2D: kind } = gl;
    gl.framebufferTexture2D(gl.FRAMEBUFFER, color, kind, this.texture.handle, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  begin(): void {
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.handle);
    this.gl.viewport(0, 0, this.texture.width, this.texture.height);
  }

  dispose(): void {
    this.gl.deleteFramebuffer(this.handle);
    this.untrack();
    this.texture.dispose();
  }
}
