import type { Gpu } from './gpu.ts';

/** A depth map that shaders compare with (`sampler2DShadow`), filtered over four texels. */
export class DepthTarget {
  readonly size: number;
  private readonly gl: WebGL2RenderingContext;
  private readonly texture: WebGLTexture;
  private readonly framebuffer: WebGLFramebuffer;
  private readonly untrack: readonly (() => void)[];

  constructor(gpu: Gpu, size: number) {
    const { gl } = gpu;
    this.gl = gl;
    this.size = size;
    this.texture = gl.createTexture();
    this.framebuffer = gl.createFramebuffer();
    this.untrack = [gpu.track('texture'), gpu.track('framebuffer')];
    const kind = gl.TEXTURE_2D;
    gl.bindTexture(kind, this.texture);
    gl.texStorage2D(kind, 1, gl.DEPTH_COMPONENT24, size, size);
    gl.texParameteri(kind, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
    gl.texParameteri(kind, gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL);
    gl.texParameteri(kind, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    gl.texParameteri(kind, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    gl.texParameteri(kind, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(kind, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, kind, this.texture, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.bindTexture(kind, null);
  }

  /** Clears the map and makes it the target of draw calls. */
  begin(): void {
    const { gl, size } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.viewport(0, 0, size, size);
    gl.clear(gl.DEPTH_BUFFER_BIT);
  }

  bind(unit: number): void {
    this.gl.activeTexture(this.gl.TEXTURE0 + unit);
    this.gl.bindTexture(this.gl.TEXTURE_2D, this.texture);
  }

  dispose(): void {
    this.gl.deleteFramebuffer(this.framebuffer);
    this.gl.deleteTexture(this.texture);
    for (const untrack of this.untrack) untrack();
  }
}
