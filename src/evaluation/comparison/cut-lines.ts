type Triple = readonly [number, number, number];

/**
 * A line on a surface, which moves with it: corner i lies on the edge from vertex `from[i]` to
 * `to[i]`, at the part `parts[i]` of its way.
 */
export interface CutLine {
  readonly from: readonly number[];
  readonly to: readonly number[];
  readonly parts: readonly number[];
  /** Whether the last corner is followed by the first. */
  readonly isClosed: boolean;
}

/**
 * Cuts triangles by a plane, in float64. A vertex on the plane counts as above it, so that every edge
 * either passes the plane once or not at all, and lines through vertices hang together like others.
 * Triangles that face outwards give lines that go counterclockwise around the inside, seen from the
 * side to which the normal points.
 *
 * @param positions (vertexCount × 3)
 * @param corners (triangleCount × 3) vertices, of those at one place always the same one
 * @param origin a point of the plane
 * @param normal of the plane, of any length
 * @returns each line once, closed ones and those that end at the surface's border
 */
export function cutLines(
  positions: Float32Array,
  corners: Uint32Array,
  origin: Triple,
  normal: Triple,
): CutLine[] {
  const count = positions.length / 3;
  const heights = heightsOver(positions, origin, normal);
  const graph = new Segments();
  for (let at = 0; at < corners.length; at += 3) {
    let [up, down] = [-1, -1];
    for (let corner = 0; corner < 3; corner++) {
      const a = corners[at + corner]!;
      const b = corners[corner === 2 ? at : at + corner + 1]!;
      const goesAbove = heights[b]! >= 0;
      if (heights[a]! >= 0 === goesAbove) continue;
      // An edge is named from its end below the plane to the one above.
      if (goesAbove) up = a * count + b;
      else down = b * count + a;
    }
    // The neighbor across the edge that leads down passes it upwards, so that the line goes on there.
    if (up >= 0) graph.add(up, down);
  }
  return graph.lines().map(({ edges, isClosed }) => {
    const from = edges.map((edge) => Math.floor(edge / count));
    const to = edges.map((edge) => edge % count);
    const parts = from.map((a, i) => heights[a]! / (heights[a]! - heights[to[i]!]!));
    return { from, to, parts, isClosed };
  });
}

/** (vertexCount) the signed distances to a plane, times the length of its normal. */
function heightsOver(p: Float32Array, [x, y, z]: Triple, [a, b, c]: Triple): Float64Array {
  const heights = new Float64Array(p.length / 3);
  for (let vertex = 0, at = 0; vertex < heights.length; vertex++, at += 3) {
    heights[vertex] = (p[at]! - x) * a + (p[at + 1]! - y) * b + (p[at + 2]! - z) * c;
  }
  return heights;
}

/** The pieces of all lines, one a triangle, and the edges at which they meet. */
class Segments {
  /** By an edge, the index of its node. */
  private readonly nodes = new Map<number, number>();
  private readonly starts: number[] = [];
  private readonly ends: number[] = [];
  private readonly edges: number[] = [];
  /** Of each node, the segments that begin and that end there. */
  private readonly leaving: number[][] = [];
  private readonly coming: number[][] = [];

  add(from: number, to: number): void {
    const [start, end] = [this.nodeOf(from), this.nodeOf(to)];
    this.leaving[start]!.push(this.starts.length);
    this.coming[end]!.push(this.starts.length);
    this.starts.push(start);
    this.ends.push(end);
  }

  /** Joins the segments. Where more than two meet, which one follows which is arbitrary. */
  lines(): { edges: number[]; isClosed: boolean }[] {
    const found: { edges: number[]; isClosed: boolean }[] = [];
    const used = new Uint8Array(this.starts.length);
    const follow = (node: number): void => {
      const passed = [node];
      for (let at = this.next(node, used); at >= 0; at = this.next(at, used)) {
        passed.push(at);
        if (at === node) break;
      }
      if (passed.length === 1) return;
      const isClosed = passed.at(-1) === node;
      if (isClosed) passed.pop();
      found.push({ edges: passed.map((each) => this.edges[each]!), isClosed });
    };
    // Open lines first, each from its beginning, or a closed walk would start in their middle.
    const isEnd = (node: number): boolean =>
      (this.leaving[node]!.length + this.coming[node]!.length) % 2 === 1;
    this.leaving.forEach((segments, node) => isEnd(node) && segments.length > 0 && follow(node));
    this.leaving.forEach((_, node) => isEnd(node) && follow(node));
    for (const [segment, start] of this.starts.entries()) if (!used[segment]) follow(start);
    return found;
  }

  /** Takes an unused segment at a node and returns the node at its other end, or -1. */
  private next(node: number, used: Uint8Array): number {
    const isFree = (segment: number): boolean => used[segment] === 0;
    const onward = this.leaving[node]!.find(isFree);
    // Of triangles that face different ways, both may begin at their common edge, or end there.
    const segment = onward ?? this.coming[node]!.find(isFree);
    if (segment === undefined) return -1;
    used[segment] = 1;
    return onward === undefined ? this.starts[segment]! : this.ends[segment]!;
  }

  private nodeOf(edge: number): number {
    let node = this.nodes.get(edge);
    if (node === undefined) {
      this.nodes.set(edge, (node = this.edges.length));
      this.edges.push(edge);
      this.leaving.push([]);
      this.coming.push([]);
    }
    return node;
  }
}
