import type { InfluenceRows } from '../../core/skin.ts';

/** Successive groups whose vertices have at most `count` influences each. */
export interface Run {
  readonly groups: number;
  readonly count: number;
}

export interface GroupedVertices {
  /** (groupCount × 4) render vertices; `vertexCount` stands for none in the last group. */
  readonly vertices: Uint32Array;
  /** With growing numbers of influences. */
  readonly runs: readonly Run[];
}

/** The bytes of one influence of a group: 4 weights (float32) and 4 palette entries (uint16). */
export const influenceBytes = 24;

/**
 * Groups vertices by four, ordered by their numbers of influences, so that the kernel rarely has to
 * skip any and its loops are predictable.
 *
 * @param pointOf (vertexCount) the point, and so the row, of each render vertex
 */
export function groupVertices(pointOf: Uint32Array, rows: InfluenceRows): GroupedVertices {
  const counts = pointOf.map((point) => rows.start[point + 1]! - rows.start[point]!);
  const vertices = new Uint32Array(4 * Math.ceil(pointOf.length / 4)).fill(pointOf.length);
  // A counting sort; vertices with equally many influences stay in order.
  const starts = new Uint32Array(counts.reduce((a, b) => Math.max(a, b), 0) + 2);
  for (const count of counts) starts[count + 1]!++;
  for (let count = 1; count < starts.length; count++) starts[count]! += starts[count - 1]!;
  counts.forEach((count, vertex) => (vertices[starts[count]!++] = vertex));
  const runs: { groups: number; count: number }[] = [];
  for (let end = 4; end <= vertices.length; end += 4) {
    const count = counts[vertices[Math.min(end, pointOf.length) - 1]!]!;
    const run = runs.at(-1);
    if (run?.count === count) run.groups++;
    else runs.push({ groups: 1, count });
  }
  return { vertices, runs };
}

/** The bytes that `packInfluences` writes. */
export function influencesSize({ runs }: GroupedVertices): number {
  return runs.reduce((bytes, { groups, count }) => bytes + groups * count * influenceBytes, 0);
}

/**
 * Writes the influences of the groups one after the other. A vertex with fewer than its group gets
 * some of weight 0, of its own last entry, which change no sum.
 *
 * @param at in bytes, a multiple of 8
 */
export function packInfluences(
  buffer: ArrayBuffer,
  at: number,
  { vertices, runs }: GroupedVertices,
  pointOf: Uint32Array,
  { start, entries, weights }: InfluenceRows,
): void {
  const floats = new Float32Array(buffer);
  const shorts = new Uint16Array(buffer);
  let group = 0;
  for (const run of runs) {
    for (const end = group + run.groups; group < end; group++, at += run.count * influenceBytes) {
      for (let lane = 0; lane < 4; lane++) {
        const point = pointOf[vertices[group * 4 + lane]!];
        if (point === undefined) continue;
        const [from, to] = [start[point]!, start[point + 1]!];
        for (let i = 0; i < run.count && from < to; i++) {
          const target = at + i * influenceBytes;
          floats[target / 4 + lane] = from + i < to ? weights[from + i]! : 0;
          shorts[target / 2 + 8 + lane] = entries[Math.min(from + i, to - 1)]!;
        }
      }
    }
  }
}
