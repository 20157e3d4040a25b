import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';

/** Neighbors: `from`, and all up to but without `to`. */
export interface Run {
  readonly from: number;
  readonly to: number;
}

/** More calls cost more than the bytes that they save: then one run spans all that changed. */
const mostRuns = 64;

/** The influences that differ between two skins whose rows are of the same lengths. */
export function changedInfluences(before: Skin, after: Skin): readonly Run[] {
  return changedRuns(after.weights.length, (i) => differAt(before, after, i));
}

/** The render vertices whose influences differ between two skins whose rows are of the same lengths. */
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
