import { assert } from '../core/assert.ts';
import { noParent, type Skeleton } from '../core/skeleton.ts';

/** A line of the joint tree. */
export interface TreeRow {
  readonly joint: number;
  /** Counted from 1, as in ARIA. */
  readonly level: number;
  readonly hasChildren: boolean;
  readonly isFolded: boolean;
}

/** The joints to show, depth first. A search shows all matching joints as a flat list. */
export function visibleRows(
  { jointCount, parents, depths, names, englishNames }: Skeleton,
  folded: ReadonlySet<number>,
  search: string,
): TreeRow[] {
  const wanted = search.trim().toLowerCase();
  const rows: TreeRow[] = [];
  let hiddenBelow = Infinity;
  for (let joint = 0; joint < jointCount; joint++) {
    const depth = depths[joint]!;
    const hasChildren = parents[joint + 1] === joint;
    if (wanted !== '') {
      const name = `${names[joint]!} ${englishNames?.[joint] ?? ''}`;
      if (name.toLowerCase().includes(wanted)) {
        rows.push({ joint, level: 1, hasChildren: false, isFolded: false });
      }
      continue;
    }
    if (depth > hiddenBelow) continue;
    const isFolded = hasChildren && folded.has(joint);
    hiddenBelow = isFolded ? depth : Infinity;
    rows.push({ joint, level: depth + 1, hasChildren, isFolded });
  }
  return rows;
}

/** The ancestors of a joint, from its parent to its root. */
export function ancestorsOf({ parents }: Skeleton, joint: number): number[] {
  assert(joint in parents, 'a joint of the skeleton');
  const ancestors: number[] = [];
  for (let above = parents[joint]!; above !== noParent; above = parents[above]!) {
    ancestors.push(above);
  }
  return ancestors;
}
