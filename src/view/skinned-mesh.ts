import type { Mesh, Submesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { Buffer } from '../gl/buffer.ts';
import { Feedback } from '../gl/feedback.ts';
import type { Gpu } from '../gl/gpu.ts';
import type { Lease } from '../gl/pool.ts';
import { Owner } from '../gl/owner.ts';
import type { Program } from '../gl/program.ts';
import { type Attribute, VertexArray } from '../gl/vertex-array.ts';
import type { MethodUse, SkinningMethod, VertexStreams } from '../skinning/method.ts';
import { createInfluenceBuffers, type InfluenceBuffers } from './influence-buffers.ts';
import type { GpuPools } from './gpu-pools.ts';
import { MeshBuffers, RestBuffers } from './mesh-buffers.ts';
import { PaletteBuffer } from './palette-buffer.ts';
import type { Programs } from './programs.ts';

const influenceUnit = 1;
const bytesPerTriple = 12;
const bytesPerIndex = 4;

/** Forces the texture layouts, so that tests can compare them with the usual ones. */
export interface LayoutChoice {
  readonly influenceTexture?: boolean;
  readonly paletteTexture?: boolean;
}

/**
 * An actor's mesh on the GPU. It shares its character's data with copies of the character, but has
 * its own buffers of posed vertices. Skinning is a separate stage: a transform feedback program, or
 * the CPU, fills those buffers once for each changed pose, and every pass draws them.
 */
export class SkinnedMesh {
  readonly mesh: Mesh;
  private readonly gpu: Gpu;
  private readonly programs: Programs;
  private readonly pools: GpuPools;
  private readonly owner = new Owner();
  private readonly shared: Lease<MeshBuffers>;
  private readonly posedPositions: Buffer;
  private readonly posedNormals: Buffer;
  private readonly feedback: Feedback;
  private readonly arrays = new Map<Program, VertexArray>();
  private readonly layout: LayoutChoice;
  /** A color of each vertex, once there are any. */
  private colors: Buffer | null = null;
  /** The vertices at rest if they differ from the mesh's own; null while they do not. */
  private shaped: RestBuffers | null = null;
  private skin: Skin;
  private influences: Lease<InfluenceBuffers>;
  private palette: PaletteBuffer | null = null;
  private paletteRowCount = 0;
  /** What the method in use prepared, and the attributes that hold it. */
  private extra: unknown;
  private extras: Readonly<Record<string, Attribute>> = {};
  private readonly extraOwner = new Owner();

  constructor(
    gpu: Gpu,
    programs: Programs,
    pools: GpuPools,
    mesh: Mesh,
    skin: Skin,
    layout: LayoutChoice = {},
  ) {
    this.gpu = gpu;
    this.programs = programs;
    this.pools = pools;
    this.mesh = mesh;
    this.skin = skin;
    this.layout = layout;
    const { owner } = this;
    const reserve = (): Buffer =>
      owner.own(new Buffer(gpu, 'vertex', mesh.vertexCount * bytesPerTriple));
    try {
      const shared = pools.meshes.lease(mesh, () => new MeshBuffers(gpu, mesh));
      this.shared = shared;
      owner.own({ dispose: () => shared.release() });
      this.posedPositions = reserve();
      this.posedNormals = reserve();
      this.feedback = owner.own(new Feedback(gpu, [this.posedPositions, this.posedNormals]));
      this.influences = this.leaseInfluences(skin);
    } catch (error) {
      owner.dispose();
      throw error;
    }
  }

  /** Replaces the weights in use; if possible, only the rows that differ are uploaded. */
  useSkin(skin: Skin): void {
    const held = this.skin;
    this.skin = skin;
    const { influences } = this.pools;
    if (influences.convert(held, skin, (buffers) => buffers.patch(held, skin))) return;
    const former = this.influences;
    this.influences = this.leaseInfluences(skin);
    former.release();
    this.forgetArrays();
  }

  /** Replaces the vertices at rest. */
  writeRest(rest: Mesh): void {
    if (rest.positions === this.mesh.positions) {
      if (!this.shaped) return;
      this.shaped.dispose();
      this.shaped = null;
      this.forgetArrays();
    } else if (this.shaped) this.shaped.write(rest);
    else {
      this.shaped = new RestBuffers(this.gpu, rest);
      this.forgetArrays();
    }
  }

  /** Fills the posed buffers on the GPU. */
  skinOnGpu(method: SkinningMethod, palette: Float32Array, { extra, settings }: MethodUse): void {
    const paletteBuffer = this.paletteFor(palette.length / 4);
    paletteBuffer.write(palette);
    const program = this.programs.skinStage({
      method,
      stride: method.vec4sPerEntry(this.skin),
      influencePairs: this.influencePairs,
      paletteRows: paletteBuffer.blockRows,
    });
    this.writeExtra(method, extra);
    program.use();
    if (method.uniforms) program.set(method.uniforms(settings));
    paletteBuffer.bind(program);
    this.bindInfluences(program);
    this.bind(program);
    this.feedback.run(this.mesh.vertexCount);
  }

  /** Uploads what a method prepared for the skin, once. */
  private writeExtra(method: SkinningMethod, extra: unknown): void {
    if (!method.attributes || extra === this.extra) return;
    this.extra = extra;
    this.extraOwner.dispose();
    const attributes = Object.entries(method.attributes(this.mesh, extra));
    this.extras = Object.fromEntries(
      attributes.map(([name, values]) => {
        const buffer = this.extraOwner.own(new Buffer(this.gpu, 'vertex', values));
        return [name, { buffer, size: 3 }];
      }),
    );
    this.forgetArrays();
  }

  /** The pairs of attributes that hold the influences, or 0 if a texture does. */
  get influencePairs(): number {
    return this.influences.value.pairs;
  }

  /** Connects the influences with a program that is in use and reads them. */
  bindInfluences(program: Program): void {
    this.influences.value.texture?.bind(influenceUnit);
    program.set({ influenceTexture: influenceUnit });
  }

  /** Fills the posed buffers with vertices that were skinned on the CPU. */
  upload(posed: VertexStreams): void {
    this.posedPositions.write(posed.positions);
    this.uploadNormals(posed);
  }

  /** Replaces the posed normals by those that were recomputed on the CPU. */
  uploadNormals({ normals }: VertexStreams): void {
    this.posedNormals.write(normals);
  }

  /** Gives each vertex a color of four bytes, which shaders read as 0 to 1. */
  writeColors(bytes: Uint8Array): void {
    if (this.colors) this.colors.write(bytes);
    else {
      this.colors = this.owner.own(new Buffer(this.gpu, 'vertex', bytes));
      this.forgetArrays();
    }
  }

  /** Connects the vertices with a program that is in use, for a draw call of the caller's own. */
  bind(program: Program): void {
    this.arrayFor(program).bind();
  }

  /** Reads back the same buffers that are drawn. */
  readBack(): VertexStreams {
    const positions = new Float32Array(this.mesh.vertexCount * 3);
    const normals = new Float32Array(this.mesh.vertexCount * 3);
    this.posedPositions.read(positions);
    this.posedNormals.read(normals);
    return { positions, normals };
  }

  /** Draws the triangles of one material with a program that is in use. */
  draw(program: Program, { firstIndex, indexCount }: Submesh): void {
    this.bind(program);
    this.drawRun(firstIndex, indexCount);
  }

  /** The same as seen from outside, where the outer sides of closed surfaces hide the inner ones. */
  drawSolid(program: Program, submesh: Submesh): void {
    const { gl } = this.gpu;
    const { firstIndex, indexCount } = submesh;
    const closed = this.shared.value.closedCount(submesh);
    this.bind(program);
    gl.enable(gl.CULL_FACE);
    this.drawRun(firstIndex, closed);
    gl.disable(gl.CULL_FACE);
    this.drawRun(firstIndex + closed, indexCount - closed);
  }

  dispose(): void {
    this.forgetArrays();
    this.palette?.dispose();
    this.shaped?.dispose();
    this.influences.release();
    this.extraOwner.dispose();
    this.owner.dispose();
  }

  private drawRun(firstIndex: number, count: number): void {
    const { gl } = this.gpu;
    if (count === 0) return;
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, firstIndex * bytesPerIndex);
  }

  private leaseInfluences(skin: Skin): Lease<InfluenceBuffers> {
    const { influenceTexture } = this.layout;
    return this.pools.influences.lease(skin, () =>
      createInfluenceBuffers(this.gpu, this.mesh, skin, influenceTexture),
    );
  }

  /** Disposes of the vertex arrays, because they refer to buffers that are no longer in use. */
  private forgetArrays(): void {
    for (const array of this.arrays.values()) array.dispose();
    this.arrays.clear();
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
      const { uvs, indices, rest: own } = this.shared.value;
      const rest = this.shaped ?? own;
      const attributes = {
        restPosition: { buffer: rest.positions, size: 3 },
        restNormal: { buffer: rest.normals, size: 3 },
        bindPosition: { buffer: own.positions, size: 3 },
        bindNormal: { buffer: own.normals, size: 3 },
        posedPosition: { buffer: this.posedPositions, size: 3 },
        posedNormal: { buffer: this.posedNormals, size: 3 },
        ...(uvs ? { uv: { buffer: uvs, size: 2 } as const } : {}),
        ...this.influences.value.attributes,
        ...this.extras,
        ...(this.colors && {
          weightColor: { buffer: this.colors, size: 4, type: 'unorm8' } as const,
        }),
      } as const;
      array = new VertexArray(this.gpu, program, attributes, indices);
      this.arrays.set(program, array);
    }
    return array;
  }
}
