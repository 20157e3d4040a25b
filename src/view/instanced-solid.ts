import { Buffer } from '../gl/buffer.ts';
import type { Gpu } from '../gl/gpu.ts';
import type { Program } from '../gl/program.ts';
import { type Attribute, VertexArray } from '../gl/vertex-array.ts';
import type { SolidShape } from './solid-shapes.ts';

/** The number of floats in an instance: a 3 × 4 matrix by rows, then a color. */
export const instanceSize = 15;

/** One shape that is drawn many times in one call. Each instance has its own matrix and color. */
export class InstancedSolid {
  private readonly gpu: Gpu;
  private readonly program: Program;
  private readonly shape: SolidShape;
  private readonly buffers: { positions: Buffer; normals: Buffer; indices: Buffer };
  private instances: { buffer: Buffer; array: VertexArray } | null = null;
  private count = 0;
  private key = '';

  constructor(gpu: Gpu, program: Program, shape: SolidShape) {
    this.gpu = gpu;
    this.program = program;
    this.shape = shape;
    this.buffers = {
      positions: new Buffer(gpu, 'vertex', shape.positions),
      normals: new Buffer(gpu, 'vertex', shape.normals),
      indices: new Buffer(gpu, 'index', shape.indices),
    };
  }

  /**
   * Replaces the instances that are drawn; does nothing while the key is the same.
   *
   * @param key identifies everything that determines the instances
   * @param create returns runs of instances (count × instanceSize), one after the other
   */
  update(key: string, create: () => readonly Float32Array[]): void {
    if (key === this.key) return;
    this.key = key;
    this.write(joined(create()));
  }

  /** Draws all instances; the program must be in use. */
  draw(): void {
    if (!this.instances || this.count === 0) return;
    const { gl } = this.gpu;
    this.instances.array.bind();
    const { length } = this.shape.indices;
    gl.drawElementsInstanced(gl.TRIANGLES, length, gl.UNSIGNED_SHORT, 0, this.count);
  }

  dispose(): void {
    this.disposeInstances();
    for (const buffer of Object.values(this.buffers)) buffer.dispose();
  }

  private write(instances: Float32Array): void {
    this.count = instances.length / instanceSize;
    if (this.count === 0) return;
    if (!this.instances || this.instances.buffer.byteLength < instances.byteLength) {
      this.disposeInstances();
      const buffer = new Buffer(this.gpu, 'vertex', instances.byteLength);
      this.instances = { buffer, array: this.createArray(buffer) };
    }
    this.instances.buffer.write(instances);
  }

  private createArray(buffer: Buffer): VertexArray {
    const stride = instanceSize * Float32Array.BYTES_PER_ELEMENT;
    const attribute = (size: 3 | 4, firstFloat: number): Attribute => ({
      buffer,
      size,
      stride,
      offset: firstFloat * Float32Array.BYTES_PER_ELEMENT,
      perInstance: true,
    });
    const attributes = {
      position: { buffer: this.buffers.positions, size: 3 },
      normal: { buffer: this.buffers.normals, size: 3 },
      otherEnd: { buffer: this.buffers.normals, size: 3 },
      instanceRow0: attribute(4, 0),
      instanceRow1: attribute(4, 4),
      instanceRow2: attribute(4, 8),
      instanceColor: attribute(3, 12),
    } as const;
    return new VertexArray(this.gpu, this.program, attributes, this.buffers.indices);
  }

  private disposeInstances(): void {
    this.instances?.array.dispose();
    this.instances?.buffer.dispose();
    this.instances = null;
  }
}

function joined(parts: readonly Float32Array[]): Float32Array {
  const all = new Float32Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
