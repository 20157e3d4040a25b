import { type Gpu, GpuLimitError } from './gpu.ts';

/**
 * In bytes. After a smaller buffer there is no question whether there was room, since the answer
 * makes the page wait for the GPU. If there was none, the next larger buffer learns of it.
 */
const questionedSize = 1024 * 1024;

type BufferTarget = 'vertex' | 'index' | 'uniform';

/** Bytes on the GPU. Whoever creates the buffer owns it and disposes of it. */
export class Buffer {
  readonly handle: WebGLBuffer;
  readonly byteLength: number;
  private readonly gl: WebGL2RenderingContext;
  private readonly target: number;
  private readonly untrack: () => void;

  /** @param content the bytes, or the number of bytes to reserve */
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
    // An index buffer that is bound while a vertex array is bound would become part of that array.
    gl.bindVertexArray(null);
    gl.bindBuffer(this.target, this.handle);
    if (typeof content === 'number') gl.bufferData(this.target, content, gl.DYNAMIC_COPY);
    else gl.bufferData(this.target, content, gl.STATIC_DRAW);
    gl.bindBuffer(this.target, null);
    if (this.byteLength >= questionedSize && gl.getError() === gl.OUT_OF_MEMORY) {
      this.dispose();
      throw new GpuLimitError(`the GPU has no room for a buffer of ${this.byteLength} bytes`);
    }
  }

  /** Overwrites the buffer from a byte offset on; the bytes before and after stay. */
  write(bytes: ArrayBufferView, offset = 0): void {
    this.gl.bindVertexArray(null);
    this.gl.bindBuffer(this.target, this.handle);
    this.gl.bufferSubData(this.target, offset, bytes);
    this.gl.bindBuffer(this.target, null);
  }

  /** Copies the start of the buffer back to the CPU, which waits for the GPU. */
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
