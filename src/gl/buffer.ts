import { type Gpu, GpuLimitError } from './gpu.ts';

type BufferTarget = 'vertex' | 'index' | 'uniform';

/** Bytes on the GPU; owned by whoever made it, who disposes of it. */
export class Buffer {
  readonly handle: WebGLBuffer;
  readonly byteLength: number;
  private readonly gl: WebGL2RenderingContext;
  private readonly target: number;
  private readonly untrack: () => void;

  /** @param content the bytes, or how many of them to reserve */
  constructor(gpu: Gpu, target: BufferTarget, content: ArrayBufferView | number) {
    const { gl } = gpu;
    this.gl = gl;
    this.target = {
      vertex: gl.ARRAY_BUFFER,
      index: gl.ELEMENT_ARRAY_BUFFER,
      uniform: gl.UNIFORM_BUFFER,
    }[target];
    this.handle = gl.createBuffer();
    this.untrack = gpu.track('buffer');
    this.byteLength = typeof content === 'number' ? content : content.byteLength;
    // An index buffer bound while a vertex array is would become part of that array.
    gl.bindVertexArray(null);
    gl.bindBuffer(this.target, this.handle);
    if (typeof content === 'number') gl.bufferData(this.target, content, gl.DYNAMIC_COPY);
    else gl.bufferData(this.target, content, gl.STATIC_DRAW);
    gl.bindBuffer(this.target, null);
    if (gl.getError() === gl.OUT_OF_MEMORY) {
      this.dispose();
      throw new GpuLimitError(`the GPU has no room for a buffer of ${this.byteLength} bytes`);
    }
  }

  /** Overwrites the buffer from a byte on; what lies before and beyond stays. */
  write(bytes: ArrayBufferView, offset = 0): void {
    this.gl.bindVertexArray(null);
    this.gl.bindBuffer(this.target, this.handle);
    this.gl.bufferSubData(this.target, offset, bytes);
    this.gl.bindBuffer(this.target, null);
  }

  /** Copies the buffer's start back; waits for the GPU. */
  read(into: ArrayBufferView): void {
    this.gl.bindBuffer(this.gl.COPY_READ_BUFFER, this.handle);
    this.gl.getBufferSubData(this.gl.COPY_READ_BUFFER, 0, into);
    this.gl.bindBuffer(this.gl.COPY_READ_BUFFER, null);
  }

  dispose(): void {
    this.gl.deleteBuffer(this.handle);
    this.untrack();
  }
}
