import { type Gpu, GpuLimitError } from './gpu.ts';
import type { TextureTarget } from './texture-target.ts';

/** A point of a picture, in pixels from its lower left corner. */
interface Corner {
  readonly x: number;
  readonly y: number;
}

interface Size {
  readonly width: number;
  readonly height: number;
}

/**
 * An offscreen picture with color and depth, usually at 4 samples a pixel. It is resolved to one
 * sample, which is both shown and read back, so a capture is exactly what was seen.
 */
export class RenderTarget {
  readonly width: number;
  readonly height: number;
  private readonly gl: WebGL2RenderingContext;
  private readonly disposers: (() => void)[] = [];
  private readonly sampled: WebGLFramebuffer;
  private readonly resolved: WebGLFramebuffer;

  constructor(gpu: Gpu, width: number, height: number, wantedSamples = 4) {
    const { gl } = gpu;
    this.gl = gl;
    this.width = width;
    this.height = height;
    const samples = Math.min(wantedSamples, gpu.maxSamples);
    this.sampled = this.createFramebuffer(gpu);
    this.attach(gpu, gl.COLOR_ATTACHMENT0, gl.RGBA8, samples);
    this.attach(gpu, gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24, samples);
    this.resolved = this.createFramebuffer(gpu);
    this.attach(gpu, gl.COLOR_ATTACHMENT0, gl.RGBA8, 0);
    const complete = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    if (!complete && !gl.isContextLost()) {
      this.dispose();
      throw new GpuLimitError(`the GPU can't draw a picture of ${width} × ${height} pixels`);
    }
  }

  /** Makes this the target of draw calls until `resolve`. */
  begin(): void {
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.sampled);
    this.gl.viewport(0, 0, this.width, this.height);
  }

  resolve(): void {
    this.copy(this.sampled, this.resolved);
  }

  /** Resolves into a texture of the same size instead, so that shaders can read the picture. */
  resolveInto({ framebuffer }: TextureTarget): void {
    this.copy(this.sampled, framebuffer);
  }

  /** Copies the resolved picture to the canvas and scales it to the canvas's size. */
  show(): void {
    const { drawingBufferWidth, drawingBufferHeight } = this.gl;
    this.copy(this.resolved, null, drawingBufferWidth, drawingBufferHeight);
  }

  /**
   * Copies another target's resolved picture into this one's, with its lower left corner at `corner`,
   * as far as it is in a rectangle of this one.
   */
  paste(part: RenderTarget, corner: Corner, clip: Corner & Size): void {
    const { gl } = this;
    const [left, bottom] = [clip.x, clip.y];
    const [right, top] = [left + clip.width, bottom + clip.height];
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, part.resolved);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, this.resolved);
    gl.blitFramebuffer(
      ...[left - corner.x, bottom - corner.y, right - corner.x, top - corner.y],
      ...[left, bottom, right, top],
      gl.COLOR_BUFFER_BIT,
      gl.NEAREST,
    );
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** Returns (width × height × 4) bytes of RGBA, the bottom row first. */
  readPixels(): Uint8Array {
    const { gl, width, height } = this;
    const pixels = new Uint8Array(width * height * 4);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.resolved);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return pixels;
  }

  dispose(): void {
    for (const dispose of this.disposers.splice(0)) dispose();
  }

  private copy(
    from: WebGLFramebuffer,
    to: WebGLFramebuffer | null,
    toWidth = this.width,
    toHeight = this.height,
  ): void {
    const { gl, width, height } = this;
    const isSameSize = toWidth === width && toHeight === height;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to);
    gl.blitFramebuffer(
      ...[0, 0, width, height],
      ...[0, 0, toWidth, toHeight],
      gl.COLOR_BUFFER_BIT,
      isSameSize ? gl.NEAREST : gl.LINEAR,
    );
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** Leaves the framebuffer bound. */
  private createFramebuffer(gpu: Gpu): WebGLFramebuffer {
    const { gl } = this;
    const handle = gl.createFramebuffer();
    const untrack = gpu.track('framebuffer');
    this.disposers.push(() => {
      gl.deleteFramebuffer(handle);
      untrack();
    });
    gl.bindFramebuffer(gl.FRAMEBUFFER, handle);
    return handle;
  }

  private attach(gpu: Gpu, attachment: number, format: number, samples: number): void {
    const { gl, width, height } = this;
    const handle = gl.createRenderbuffer();
    const untrack = gpu.track('renderbuffer');
    this.disposers.push(() => {
      gl.deleteRenderbuffer(handle);
      untrack();
    });
    gl.bindRenderbuffer(gl.RENDERBUFFER, handle);
    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, handle);
    gl.bindRenderbuffer(gl.RENDERBUFFER, null);
  }
}
