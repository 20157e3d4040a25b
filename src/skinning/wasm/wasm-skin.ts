import type { Mesh } from '../../core/mesh.ts';
import type { PosedStreams, WasmPlan, WasmRows } from '../method.ts';
import {
  groupVertices,
  type GroupedVertices,
  influenceBytes,
  influencesSize,
  packInfluences,
} from './pack-influences.ts';

/** The functions of kernel.as. Addresses are in bytes. */
interface KernelFunctions {
  blendMatrices(
    groups: number,
    count: number,
    influences: number,
    palette: number,
    stride: number,
    matrices: number,
  ): void;
  signPalette(
    count: number,
    pairs: number,
    palette: number,
    stride: number,
    rotation: number,
    from: number,
    out: number,
  ): void;
  blendDualQuaternions(
    groups: number,
    count: number,
    influences: number,
    palette: number,
    matrices: number,
  ): number;
  turnAboutCenters(
    groups: number,
    count: number,
    influences: number,
    palette: number,
    centers: number,
    points: number,
    matrices: number,
    places: number,
  ): void;
  readonly transformPoints: Transform;
  readonly transformNormals: Transform;
  readonly transformNormalsByCofactors: Transform;
}

type Transform = (
  groups: number,
  matrices: number,
  vectors: number,
  targets: number,
  out: number,
) => void;

/** Groups whose matrices fit into the processor's nearest cache. */
const blockSize = 64;
const vectorBytes = 48;
const targetBytes = 16;
const matrixBytes = 192;
/** The longest palette entry of a method. */
const floatsPerEntry = 32;
/** Where an entry has its rotation, if it has one. */
const rotationAt = 48;
/** The bytes of an entry of a signed palette: a dual quaternion, or a matrix and a rotation. */
const dualBytes = 32;
const turningBytes = 64;
const pageBytes = 65536;
/** A WebAssembly memory has at most 4 GiB. */
const mostPages = 65536;

/**
 * A skin and its mesh in the memory of the WebAssembly kernel, in an order of its own. The memory
 * has exactly the size that they need, so it never grows, and it is released with this object.
 */
export class WasmSkin {
  private readonly kernel: KernelFunctions;
  private readonly pointOf: Uint32Array;
  private readonly groups: GroupedVertices;
  private readonly entryCount: number;
  /** The mesh at rest whose points and normals are in the memory. */
  private rest: Mesh | undefined;

  private readonly influencesAt: number;
  private readonly targetsAt: number;
  private readonly matricesAt: number;
  private readonly pairCount: number;
  private readonly pairsAt: number;
  private readonly signedAt: number;
  private readonly placesAt: number;
  /** The centers of the groups, if the plan has any. */
  private readonly centers: Float32Array;
  /** The centers that are in the memory. */
  private centersInUse: Float32Array | undefined;
  private readonly points: Float32Array;
  private readonly normals: Float32Array;
  private readonly palette: Float32Array;
  private readonly posedPoints: Float32Array;
  private readonly posedNormals: Float32Array;

  /** Throws a RangeError if there is not enough memory. */
  constructor(
    module: WebAssembly.Module,
    mesh: Mesh,
    rows: WasmRows,
    entryCount: number,
    hasCenters: boolean,
  ) {
    this.entryCount = entryCount;
    const { pointOf, vertexCount } = mesh;
    this.pointOf = pointOf;
    this.groups = groupVertices(pointOf, rows);
    const groupCount = this.groups.vertices.length / 4;
    let size = 0;
    const reserve = (bytes: number): number => {
      const at = size;
      size += Math.ceil(bytes / 16) * 16;
      return at;
    };
    this.influencesAt = reserve(influencesSize(this.groups));
    this.targetsAt = reserve(groupCount * targetBytes);
    this.matricesAt = reserve((blockSize + 1) * matrixBytes);
    const points = reserve(groupCount * vectorBytes);
    const normals = reserve(groupCount * vectorBytes);
    const palette = reserve(entryCount * floatsPerEntry * 4);
    const { pairs = new Uint16Array(0) } = rows;
    this.pairCount = pairs.length / 2;
    this.pairsAt = reserve(pairs.byteLength);
    this.signedAt = reserve(this.pairCount * (hasCenters ? turningBytes : dualBytes));
    this.placesAt = reserve(hasCenters ? blockSize * vectorBytes : 0);
    const centersCount = hasCenters ? groupCount * 12 : 0;
    const centers = reserve(centersCount * 4);
    // One vertex more takes what the kernel computes for the missing ones of the last group.
    const posedPoints = reserve((vertexCount + 1) * 12);
    const posedNormals = reserve((vertexCount + 1) * 12);

    const initial = Math.ceil(size / pageBytes);
    if (initial > mostPages) throw new RangeError(`${initial} pages of memory`);
    const memory = new WebAssembly.Memory({ initial });
    const instance = new WebAssembly.Instance(module, { env: { memory } });
    this.kernel = instance.exports as unknown as KernelFunctions;
    const { buffer } = memory;
    this.points = new Float32Array(buffer, points, groupCount * 12);
    this.centers = new Float32Array(buffer, centers, centersCount);
    this.normals = new Float32Array(buffer, normals, groupCount * 12);
    this.palette = new Float32Array(buffer, palette, entryCount * floatsPerEntry);
    this.posedPoints = new Float32Array(buffer, posedPoints, vertexCount * 3);
    this.posedNormals = new Float32Array(buffer, posedNormals, vertexCount * 3);
    new Uint16Array(buffer, this.pairsAt, pairs.length).set(pairs);
    packInfluences(buffer, this.influencesAt, this.groups, pointOf, rows);
    const targets = new Uint32Array(buffer, this.targetsAt, groupCount * 4);
    this.groups.vertices.forEach((vertex, i) => (targets[i] = vertex * 12));
  }

  /** Whether it was made for the render vertices of this mesh. */
  fits({ pointOf }: Mesh): boolean {
    return pointOf === this.pointOf;
  }

  /**
   * Computes what `method.deform` does, bit by bit. Vertices whose rotations cancel out are not
   * computed; their positions are no numbers, and the result is true.
   *
   * @param centers (pointCount × 3) for a plan with centers
   */
  deform(
    plan: WasmPlan,
    mesh: Mesh,
    palette: Float32Array,
    out: PosedStreams,
    centers?: Float32Array,
  ): boolean {
    const { kernel, matricesAt, signedAt, placesAt } = this;
    this.useRest(mesh);
    if (centers) this.useCenters(centers);
    this.palette.set(palette);
    const paletteAt = this.palette.byteOffset;
    const stride = palette.byteLength / this.entryCount;
    const { pairCount, pairsAt } = this;
    const from = centers ? 0 : rotationAt;
    kernel.signPalette(pairCount, pairsAt, paletteAt, stride, rotationAt, from, signedAt);
    let influences = this.influencesAt;
    let points = this.points.byteOffset;
    let normals = this.normals.byteOffset;
    let targets = this.targetsAt;
    let centersAt = this.centers.byteOffset;
    let isLost = 0;
    for (const { groups, count } of this.groups.runs) {
      for (let first = 0; first < groups; first += blockSize) {
        const size = Math.min(blockSize, groups - first);
        const posedPoints = this.posedPoints.byteOffset;
        const posedNormals = this.posedNormals.byteOffset;
        if (plan.blend === 'dual-quaternions') {
          isLost |= kernel.blendDualQuaternions(size, count, influences, signedAt, matricesAt);
        } else {
          const [entries, bytes] = centers ? [signedAt, turningBytes] : [paletteAt, stride];
          kernel.blendMatrices(size, count, influences, entries, bytes, matricesAt);
        }
        if (centers) {
          kernel.turnAboutCenters(
            ...([size, count, influences, signedAt] as const),
            ...([centersAt, points, matricesAt, placesAt] as const),
          );
        }
        const places = centers ? placesAt : points;
        kernel.transformPoints(size, matricesAt, places, targets, posedPoints);
        if (out.normals && plan.normals === 'cofactors') {
          kernel.transformNormalsByCofactors(size, matricesAt, normals, targets, posedNormals);
        } else if (out.normals) {
          // The rows for normals follow those for points.
          kernel.blendMatrices(size, count, influences, paletteAt + 48, stride, matricesAt);
          kernel.transformNormals(size, matricesAt, normals, targets, posedNormals);
        }
        influences += size * count * influenceBytes;
        points += size * vectorBytes;
        centersAt += size * vectorBytes;
        normals += size * vectorBytes;
        targets += size * targetBytes;
      }
    }
    out.positions.set(this.posedPoints);
    out.normals?.set(this.posedNormals);
    return isLost !== 0;
  }

  /** Copies the mesh at rest into the memory, if it is another than before. */
  private useRest(mesh: Mesh): void {
    if (this.rest === mesh) return;
    this.rest = mesh;
    this.spread(mesh.positions, this.points, (vertex) => vertex);
    this.spread(mesh.normals, this.normals, (vertex) => vertex);
  }

  private useCenters(centers: Float32Array): void {
    if (this.centersInUse === centers) return;
    this.centersInUse = centers;
    this.spread(centers, this.centers, (vertex) => this.pointOf[vertex]!);
  }

  /** Copies triples into groups. */
  private spread(
    triples: Float32Array,
    groups: Float32Array,
    indexOf: (vertex: number) => number,
  ): void {
    const { vertices } = this.groups;
    for (let i = 0; i < vertices.length; i++) {
      const vertex = vertices[i]!;
      if (vertex === this.pointOf.length) continue;
      const to = (i >> 2) * 12 + (i & 3);
      const from = indexOf(vertex) * 3;
      for (let axis = 0; axis < 3; axis++) groups[to + axis * 4] = triples[from + axis]!;
    }
  }
}
