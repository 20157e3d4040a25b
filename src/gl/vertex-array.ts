import type { Buffer } from './buffer.ts';
import type { Gpu } from './gpu.ts';
import type { Program } from './program.ts';

export interface Attribute {
  readonly buffer: Buffer;
  /** The number of components per vertex, 1 to 4. */
  readonly size: 1 | 2 | 3 | 4;
  /** 'unorm8' are bytes that the shader reads as 0 to 1. */
  readonly type?: 'float' | 'unorm8' | 'uint16' | 'uint32';
  /**
   * `stride` is the number of bytes from one vertex to the next and `offset` the number before the
   * first. Attributes are packed if both are absent.
   */
  readonly stride?: number;
  readonly offset?: number;
  /** If true, the attribute advances once per instance, not once per vertex. */
  readonly perInstance?: boolean;
}

/** Connects buffers to the attributes of one program, together with the indices for drawing. */
export class VertexArray {
  private readonly gl: WebGL2RenderingContext;
  private readonly handle: WebGLVertexArrayObject;
  private readonly untrack: () => void;

  /** Attributes that the program does not read are ignored. */
  constructor(
    gpu: Gpu,
    program: Program,
    attributes: Readonly<Record<string, Attribute>>,
    indices?: Buffer,
  ) {
    const { gl } = gpu;
    this.gl = gl;
    this.handle = gl.createVertexArray();
    this.untrack = gpu.track('vertex-array');
    gl.bindVertexArray(this.handle);
    for (const [name, attribute] of Object.entries(attributes)) {
      const location = program.attribute(name);
      if (location >= 0) this.connect(location, attribute);
    }
    if (indices) gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices.handle);
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
  }

  bind(): void {
    this.gl.bindVertexArray(this.handle);
  }

  dispose(): void {
    this.gl.deleteVertexArray(this.handle);
    this.untrack();
  }

  private connect(location: number, attribute: Attribute): void {
    const { gl } = this;
    const { buffer, size, type = 'float', stride = 0, offset = 0, perInstance } = attribute;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer.handle);
    gl.enableVertexAttribArray(location);
    if (type === 'float') {
      gl.vertexAttribPointer(location, size, gl.FLOAT, false, stride, offset);
    } else if (type === 'unorm8') {
      gl.vertexAttribPointer(location, size, gl.UNSIGNED_BYTE, true, stride, offset);
    } else {
      const integer = type === 'uint16' ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT;
      gl.vertexAttribIPointer(location, size, integer, stride, offset);
    }
    if (perInstance) gl.vertexAttribDivisor(location, 1);
  }
}
