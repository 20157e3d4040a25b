/** Kinds of GL object that are counted, so that a test can show that none leaks. */
export type ObjectKind =
  | 'buffer'
  | 'framebuffer'
  | 'program'
  | 'renderbuffer'
  | 'texture'
  | 'transform-feedback'
  | 'vertex-array';

/**
 * A WebGL2 context with its limits and the count of its live objects. After the context is lost,
 * everything is created again from data on the CPU; no object here can restore itself.
 */
export class Gpu {
  readonly gl: WebGL2RenderingContext;
  readonly maxUniformBlockSize: number;
  readonly maxTextureSize: number;
  readonly maxSamples: number;
  private readonly counts = new Map<ObjectKind, number>();

  constructor(gl: WebGL2RenderingContext) {
    this.gl = gl;
    this.maxUniformBlockSize = gl.getParameter(gl.MAX_UNIFORM_BLOCK_SIZE) as number;
    this.maxTextureSize = gl.getParameter(gl.MAX_TEXTURE_SIZE) as number;
    this.maxSamples = gl.getParameter(gl.MAX_SAMPLES) as number;
  }

  /**
   * Counts a new object. The returned function removes it from the count; calling it again does
   * nothing.
   */
  track(kind: ObjectKind): () => void {
    this.counts.set(kind, this.count(kind) + 1);
    let live = true;
    return () => {
      if (live) this.counts.set(kind, this.count(kind) - 1);
      live = false;
    };
  }

  count(kind: ObjectKind): number {
    return this.counts.get(kind) ?? 0;
  }

  get liveObjects(): Readonly<Record<string, number>> {
    return Object.fromEntries(this.counts);
  }
}

/**
 * The GPU refused something for lack of memory or because of its size limits. The message is for
 * the user; this is not a bug.
 */
export class GpuLimitError extends Error {}
