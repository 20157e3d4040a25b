import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';

/** A range of neighbors from `from` up to but not including `to`. */
export interface Run {
  readonly from: number;
  readonly to: number;
}

/**
 * More calls than this cost more than the bytes that they save, so one run then spans everything
 * that changed.
 */
const mostRuns = 64;

/** Returns the influences that differ between two skins whose rows have the same lengths. */
export function changedInfluences(before: Skin, after: Skin): readonly Run[] {
  return changedRuns(after.weights.length, (i) => differAt(before, after, i));
}

/**
 * Returns the render vertices whose influences differ between two skins whose rows have the same
 * lengths.
 */
export function changedVertices(mesh: Mesh, before: Skin, after: Skin): readonly Run[] {
  return changedRuns(mesh.vertexCount, (vertex) => {
    const point = mesh.pointOf[vertex]!;
    for (let i = after.start[point]!; i < after.start[point + 1]!; i++) {
      if (differAt(before, after, i)) return true;
    }
    return false;
  });
}

function differAt(before: Skin, after: Skin, influence: number): boolean {
  return (
    before.entries[influence] !== after.entries[influence] ||
    before.weights[influence] !== after.weights[influence]
  );
}

function changedRuns(count: number, changed: (index: number) => boolean): readonly Run[] {
  const runs: Run[] = [];
  for (let from = 0; from < count; from++) {
    if (!changed(from)) continue;
    let to = from + 1;
    while (to < count && changed(to)) to++;
    runs.push({ from, to });
    from = to;
  }
  return runs.length <= mostRuns ? runs : [{ from: runs[0]!.from, to: runs.at(-1)!.to }];
}
