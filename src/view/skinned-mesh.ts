import type { Mesh, Submesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { Buffer } from '../gl/buffer.ts';
import { Feedback } from '../gl/feedback.ts';
import type { Gpu } from '../gl/gpu.ts';
import { Owner } from '../gl/owner.ts';
import type { Program } from '../gl/program.ts';
import { VertexArray } from '../gl/vertex-array.ts';
import type { SkinningMethod, VertexStreams } from '../skinning/method.ts';
import { createInfluenceBuffers, type InfluenceBuffers } from './influence-buffers.ts';
import { PaletteBuffer } from './palette-buffer.ts';
import type { Programs } from './programs.ts';

const influenceUnit = 1;
const bytesPerTriple = 12;
const bytesPerIndex = 4;

/** Forces the texture variants, so that tests can compare them with the usual ones. */
export interface LayoutChoice {
  readonly influenceTexture?: boolean;
  readonly paletteTexture?: boolean;
}

/**
 * A mesh on the GPU with the buffers that hold its posed vertices. Skinning is a stage: a transform
 * feedback program, or the CPU, fills those buffers once for a changed pose; every pass draws them.
 */
export class SkinnedMesh {
  readonly mesh: Mesh;
  private readonly gpu: Gpu;
  private readonly programs: Programs;
  private readonly owner = new Owner();
  private readonly restPositions: Buffer;
  private readonly restNormals: Buffer;
  private readonly posedPositions: Buffer;
  private readonly posedNormals: Buffer;
  private readonly indices: Buffer;
  private readonly uvs: Buffer | null;
  private readonly influences: InfluenceBuffers;
  private readonly feedback: Feedback;
  private readonly arrays = new Map<Program, VertexArray>();
  private palette: PaletteBuffer | null = null;
  private paletteRowCount = 0;
  private readonly layout: LayoutChoice;

  constructor(gpu: Gpu, programs: Programs, mesh: Mesh, skin: Skin, layout: LayoutChoice = {}) {
    this.gpu = gpu;
    this.programs = programs;
    this.mesh = mesh;
    this.layout = layout;
    const { owner } = this;
    const reserve = (): Buffer =>
      owner.own(new Buffer(gpu, 'vertex', mesh.vertexCount * bytesPerTriple));
    try {
      this.restPositions = owner.own(new Buffer(gpu, 'vertex', mesh.positions));
      this.restNormals = owner.own(new Buffer(gpu, 'vertex', mesh.normals));
      this.posedPositions = reserve();
      this.posedNormals = reserve();
      this.indices = owner.own(new Buffer(gpu, 'index', mesh.indices));
      this.uvs = mesh.uvs && owner.own(new Buffer(gpu, 'vertex', mesh.uvs));
      this.influences = createInfluenceBuffers(owner, gpu, mesh, skin, layout.influenceTexture);
      this.feedback = owner.own(new Feedback(gpu, [this.posedPositions, this.posedNormals]));
    } catch (error) {
      owner.dispose();
      throw error;
    }
  }

  /** Puts other vertices at rest in the place of the mesh's own. */
  writeRest({ positions, normals }: VertexStreams): void {
    this.restPositions.write(positions);
    this.restNormals.write(normals);
  }

  /** Fills the posed buffers on the GPU. */
  skinOnGpu(method: SkinningMethod, palette: Float32Array): void {
    const paletteBuffer = this.paletteFor(palette.length / 4);
    paletteBuffer.write(palette);
    const program = this.programs.skinStage({
      method,
      influencePairs: this.influences.pairs,
      paletteRows: paletteBuffer.blockRows,
    });
    program.use();
    paletteBuffer.bind(program);
    this.influences.texture?.bind(influenceUnit);
    program.set({ influenceTexture: influenceUnit });
    this.arrayFor(program).bind();
    this.feedback.run(this.mesh.vertexCount);
  }

  /** Fills the posed buffers with vertices that the CPU skinned. */
  upload({ positions, normals }: VertexStreams): void {
    this.posedPositions.write(positions);
    this.posedNormals.write(normals);
  }

  /** Reads back the very buffers that are drawn. */
  readBack(): VertexStreams {
    const positions = new Float32Array(this.mesh.vertexCount * 3);
    const normals = new Float32Array(this.mesh.vertexCount * 3);
    this.posedPositions.read(positions);
    this.posedNormals.read(normals);
    return { positions, normals };
  }

  /** Draws all triangles, or those of one material, with a program that is in use. */
  draw(program: Program, submesh?: Submesh): void {
    const { gl } = this.gpu;
    this.arrayFor(program).bind();
    const { firstIndex = 0, indexCount = this.mesh.indices.length } = submesh ?? {};
    gl.drawElements(gl.TRIANGLES, indexCount, gl.UNSIGNED_INT, firstIndex * bytesPerIndex);
  }

  dispose(): void {
    for (const array of this.arrays.values()) array.dispose();
    this.palette?.dispose();
    this.owner.dispose();
  }

  private paletteFor(rowCount: number): PaletteBuffer {
    if (!this.palette || this.paletteRowCount !== rowCount) {
      this.palette?.dispose();
      this.palette = new PaletteBuffer(this.gpu, rowCount, this.layout.paletteTexture);
      this.paletteRowCount = rowCount;
    }
    return this.palette;
  }

  private arrayFor(program: Program): VertexArray {
    let array = this.arrays.get(program);
    if (!array) {
      const attributes = {
        restPosition: { buffer: this.restPositions, size: 3 },
        restNormal: { buffer: this.restNormals, size: 3 },
        posedPosition: { buffer: this.posedPositions, size: 3 },
        posedNormal: { buffer: this.posedNormals, size: 3 },
        ...(this.uvs ? { uv: { buffer: this.uvs, size: 2 } as const } : {}),
        ...this.influences.attributes,
      } as const;
      array = new VertexArray(this.gpu, program, attributes, this.indices);
      this.arrays.set(program, array);
    }
    return array;
  }
}
