import { type Gpu, GpuLimitError } from './gpu.ts';

/** An offscreen picture of four whole numbers of 32 bits a pixel, with depth and one sample. */
export class IntegerTarget {
  readonly width: number;
  readonly height: number;
  private readonly gl: WebGL2RenderingContext;
  private readonly framebuffer: WebGLFramebuffer;
  private readonly buffers: readonly WebGLRenderbuffer[];
  private readonly untrack: readonly (() => void)[];

  constructor(gpu: Gpu, width: number, height: number) {
    const { gl } = gpu;
    this.gl = gl;
    this.width = width;
    this.height = height;
    this.framebuffer = gl.createFramebuffer();
    this.untrack = [gpu.track('framebuffer'), gpu.track('renderbuffer'), gpu.track('renderbuffer')];
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    this.buffers = [
      this.attach(gl.COLOR_ATTACHMENT0, gl.RGBA32UI),
      this.attach(gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24),
    ];
    const complete = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    if (complete || gl.isContextLost()) return;
    this.dispose();
    throw new GpuLimitError(`the GPU can't draw numbers of ${width} × ${height} pixels`);
  }

  /** Makes this the target of draw calls and clears it. */
  begin(): void {
    const { gl, width, height } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.viewport(0, 0, width, height);
    gl.clearBufferuiv(gl.COLOR, 0, [0, 0, 0, 0]);
    gl.clear(gl.DEPTH_BUFFER_BIT);
  }

  /** Returns (width × height × 4) numbers, the bottom row first. */
  readPixels(): Uint32Array {
    const { gl, width, height } = this;
    const pixels = new Uint32Array(width * height * 4);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, pixels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return pixels;
  }

  dispose(): void {
    this.gl.deleteFramebuffer(this.framebuffer);
    for (const buffer of this.buffers) this.gl.deleteRenderbuffer(buffer);
    for (const untrack of this.untrack) untrack();
  }

  private attach(attachment: number, format: number): WebGLRenderbuffer {
    const { gl } = this;
    const buffer = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
    gl.renderbufferStorage(gl.RENDERBUFFER, format, this.width, this.height);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
    gl.bindRenderbuffer(gl.RENDERBUFFER, null);
    return buffer;
  }
}
