import type { Gpu } from './gpu.ts';
import { Texture } from './texture.ts';

/** A color texture that can be drawn into; shadows and their blur use it. */
export class TextureTarget {
  readonly texture: Texture;
  private readonly gl: WebGL2RenderingContext;
  readonly framebuffer: WebGLFramebuffer;
  private readonly untrack: () => void;

  constructor(gpu: Gpu, width: number, height: number) {
    const { gl } = gpu;
    this.gl = gl;
    this.texture = new Texture(gpu, 'color-rgba8', width, height);
    this.framebuffer = gl.createFramebuffer();
    this.untrack = gpu.track('framebuffer');
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    const { COLOR_ATTACHMENT0: color, TEXTURE_2D: kind } = gl;
    gl.framebufferTexture2D(gl.FRAMEBUFFER, color, kind, this.texture.handle, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  begin(): void {
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.framebuffer);
    this.gl.viewport(0, 0, this.texture.width, this.texture.height);
  }

  dispose(): void {
    this.gl.deleteFramebuffer(this.framebuffer);
    this.untrack();
    this.texture.dispose();
  }
}
