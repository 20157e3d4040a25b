import type { Mesh, Submesh } from '../core/mesh.ts';
import { Buffer } from '../gl/buffer.ts';
import type { Gpu } from '../gl/gpu.ts';
import { Owner } from '../gl/owner.ts';
import type { VertexStreams } from '../skinning/method.ts';
import { refinement } from './refinement.ts';

/** The vertices at rest, as the skinning stage reads them. */
export class RestBuffers {
  readonly positions: Buffer;
  readonly normals: Buffer;
  private readonly owner = new Owner();

  constructor(gpu: Gpu, { positions, normals }: VertexStreams) {
    try {
      this.positions = this.owner.own(new Buffer(gpu, 'vertex', positions));
      this.normals = this.owner.own(new Buffer(gpu, 'vertex', normals));
    } catch (error) {
      this.owner.dispose();
      throw error;
    }
  }

  write({ positions, normals }: VertexStreams): void {
    this.positions.write(positions);
    this.normals.write(normals);
  }

  dispose(): void {
    this.owner.dispose();
  }
}

/** A mesh as its files define it, which never changes. */
export class MeshBuffers {
  readonly rest: RestBuffers;
  readonly indices: Buffer;
  readonly uvs: Buffer | null;
  private readonly mesh: Mesh;
  private closedCounts: ReadonlyMap<Submesh, number> | null = null;
  private readonly owner = new Owner();

  constructor(gpu: Gpu, mesh: Mesh) {
    const { owner } = this;
    this.mesh = mesh;
    try {
      this.rest = owner.own(new RestBuffers(gpu, mesh));
      this.indices = owner.own(new Buffer(gpu, 'index', mesh.indices));
      this.uvs = mesh.uvs && owner.own(new Buffer(gpu, 'vertex', mesh.uvs));
    } catch (error) {
      owner.dispose();
      throw error;
    }
  }

  /**
   * How many indices of a submesh belong to closed surfaces; these come first. None are known in the
   * first picture.
   */
  closedCount(submesh: Submesh): number {
    const code = refinement.loaded;
    if (code && !this.closedCounts) {
      const { indices, closedCounts } = code.closedTriangles(this.mesh);
      this.indices.write(indices);
      this.closedCounts = closedCounts;
    }
    return this.closedCounts?.get(submesh) ?? 0;
  }

  dispose(): void {
    this.owner.dispose();
  }
}
