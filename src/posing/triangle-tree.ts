import type { Mesh } from '../core/mesh.ts';
import type { Ray } from '../core/ray.ts';
import { rayTriangle, type TriangleMeeting } from '../core/ray-triangle.ts';
import { neighborOrder } from './neighbor-order.ts';

/** Testing about this many triangles is faster than splitting them further. */
const leafSize = 8;

/** The triangle that a ray hits first; its index counts triples of `Mesh.indices`. */
export type TriangleHit = Readonly<MutableHit>;

type MutableHit = TriangleMeeting & { triangle: number };

/**
 * The triangles of a mesh in a tree of bounding boxes, so that a ray is tested against few of them.
 * The tree is built from the mesh at rest; its boxes are fitted to the posed mesh (`refit`).
 *
 * Each node halves its run of triangles, so that node n has the children 2n + 1 and 2n + 2 and all
 * leaves are in the last level. Only the boxes need to be stored.
 */
export class TriangleTree {
  private readonly indices: Uint32Array;
  /** (triangleCount) */
  private readonly order: Uint32Array;
  private readonly firstLeaf: number;
  /** (nodeCount × 6) minimum, then maximum coordinates. */
  private readonly boxes: Float32Array;
  private positions: Float32Array;

  constructor(mesh: Mesh) {
    this.indices = mesh.indices;
    this.order = orderOf(mesh);
    const levels = Math.ceil(Math.log2(Math.max(1, this.order.length / leafSize)));
    this.firstLeaf = 2 ** levels - 1;
    this.boxes = new Float32Array((2 * this.firstLeaf + 1) * 6);
    this.positions = mesh.positions;
    this.refit(mesh.positions);
  }

  /**
   * Fits the boxes to other positions of the vertices. The array is kept and must not be written
   * until the next call. Nothing is allocated.
   *
   * @param positions (vertexCount × 3) in the character's space
   */
  refit(positions: Float32Array): void {
    this.positions = positions;
    this.fit(0, 0, this.order.length);
  }

  /**
   * Returns the triangle that the ray hits first, from either side; of equally near ones the first
   * of the mesh.
   */
  nearest(ray: Ray): TriangleHit | null {
    const nearest = { triangle: -1, distance: Infinity, second: 0, third: 0 };
    if (this.order.length > 0) this.visit(ray, nearest, 0, 0, this.order.length);
    return nearest.triangle === -1 ? null : nearest;
  }

  private fit(node: number, from: number, to: number): void {
    const { boxes } = this;
    const at = node * 6;
    boxes.fill(Infinity, at, at + 3).fill(-Infinity, at + 3, at + 6);
    if (node >= this.firstLeaf) {
      for (let i = from; i < to; i++) this.includeTriangle(at, this.order[i]! * 3);
      return;
    }
    const middle = (from + to) >> 1;
    this.fit(2 * node + 1, from, middle);
    this.fit(2 * node + 2, middle, to);
    for (let child = 12 * node + 6; child < 12 * node + 18; child += 6) {
      for (let axis = 0; axis < 3; axis++) {
        boxes[at + axis] = Math.min(boxes[at + axis]!, boxes[child + axis]!);
        boxes[at + 3 + axis] = Math.max(boxes[at + 3 + axis]!, boxes[child + 3 + axis]!);
      }
    }
  }

  /** NaN coordinates are skipped, because a ray hits no triangle that has any. */
  private includeTriangle(at: number, first: number): void {
    const { boxes, indices, positions } = this;
    for (let corner = 0; corner < 3; corner++) {
      const vertex = indices[first + corner]! * 3;
      for (let axis = 0; axis < 3; axis++) {
        const value = positions[vertex + axis]!;
        if (value < boxes[at + axis]!) boxes[at + axis] = value;
        if (value > boxes[at + 3 + axis]!) boxes[at + 3 + axis] = value;
      }
    }
  }

  private visit(ray: Ray, nearest: MutableHit, node: number, from: number, to: number): void {
    if (node >= this.firstLeaf) {
      for (let i = from; i < to; i++) this.tryTriangle(ray, nearest, this.order[i]!);
      return;
    }
    const [left, right, middle] = [2 * node + 1, 2 * node + 2, (from + to) >> 1];
    const [toLeft, toRight] = [this.entry(ray, left), this.entry(ray, right)];
    const leftFirst = toLeft <= toRight;
    if (leftFirst && toLeft <= nearest.distance) this.visit(ray, nearest, left, from, middle);
    if (toRight <= nearest.distance) this.visit(ray, nearest, right, middle, to);
    if (!leftFirst && toLeft <= nearest.distance) this.visit(ray, nearest, left, from, middle);
  }

  private tryTriangle(ray: Ray, nearest: MutableHit, triangle: number): void {
    const { indices, positions } = this;
    const a = indices[triangle * 3]! * 3;
    const b = indices[triangle * 3 + 1]! * 3;
    const c = indices[triangle * 3 + 2]! * 3;
    if (!rayTriangle(ray, positions, a, b, c, met) || met.distance > nearest.distance) return;
    if (met.distance === nearest.distance && triangle > nearest.triangle) return;
    Object.assign(nearest, met, { triangle });
  }

  /**
   * The distance along the ray at which it enters a node's box, or Infinity: the slab test (Kay and
   * Kajiya 1986). It may accept near misses by rounding, because it only avoids tests of triangles.
   */
  private entry({ origin, direction }: Ray, node: number): number {
    const { boxes } = this;
    let enter = 0;
    let leave = Infinity;
    for (let axis = 0; axis < 3; axis++) {
      const from = origin[axis]!;
      const slope = direction[axis]!;
      const low = boxes[node * 6 + axis]!;
      const high = boxes[node * 6 + 3 + axis]!;
      const slack = 1e-9 * (Math.abs(low) + Math.abs(high) + Math.abs(from));
      if (slope === 0) {
        if (!(from >= low - slack && from <= high + slack)) return Infinity;
        continue;
      }
      const first = ((slope > 0 ? low : high) - from) / slope;
      const last = ((slope > 0 ? high : low) - from) / slope;
      const room = slack / Math.abs(slope);
      enter = Math.max(enter, first - room);
      leave = Math.min(leave, last + room);
    }
    return enter <= leave ? enter : Infinity;
  }
}

/** Written by every test. */
const met: TriangleMeeting = { distance: 0, second: 0, third: 0 };

/** Sorted once per mesh, however many of its poses are picked. */
function orderOf(mesh: Mesh): Uint32Array {
  const known = orders.get(mesh)?.deref();
  if (known) return known;
  const order = neighborOrder(mesh, leafSize);
  orders.set(mesh, new WeakRef(order));
  return order;
}

/**
 * Only trees keep these alive, because the history may contain meshes that nobody picks any more.
 */
const orders = new WeakMap<Mesh, WeakRef<Uint32Array>>();
