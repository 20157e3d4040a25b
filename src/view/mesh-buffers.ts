import type { Mesh, Submesh } from '../core/mesh.ts';
import { Buffer } from '../gl/buffer.ts';
import type { Gpu } from '../gl/gpu.ts';
import { Owner } from '../gl/owner.ts';
import type { VertexStreams } from '../skinning/method.ts';
import { closedTriangles } from './closed-triangles.ts';

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
  /** Those of closed surfaces come first in each submesh. */
  readonly indices: Buffer;
  /** How many indices of each submesh belong to closed surfaces. */
  readonly closedCounts: ReadonlyMap<Submesh, number>;
  readonly uvs: Buffer | null;
  private readonly owner = new Owner();

  constructor(gpu: Gpu, mesh: Mesh) {
    const { owner } = this;
    try {
      this.rest = owner.own(new RestBuffers(gpu, mesh));
      const { indices, closedCounts } = closedTriangles(mesh);
      this.indices = owner.own(new Buffer(gpu, 'index', indices));
      this.closedCounts = closedCounts;
      this.uvs = mesh.uvs && owner.own(new Buffer(gpu, 'vertex', mesh.uvs));
    } catch (error) {
      owner.dispose();
      throw error;
    }
  }

  dispose(): void {
    this.owner.dispose();
  }
}
