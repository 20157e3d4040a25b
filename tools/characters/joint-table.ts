import { readFileSync } from 'node:fs';
import { join } from 'node:path';

/**
 * The joints in file order, depth first, parents first. `bones` are the names in the source, '' for
 * the added root.
 */
export interface JointTable {
  readonly names: readonly string[];
  readonly parents: readonly number[];
  readonly bones: readonly string[];
}

/** Reads `NAME-joints.json`, which is beside this file. */
export function readJointTable(character: string): JointTable {
  const path = join(import.meta.dirname, `${character}-joints.json`);
  return JSON.parse(readFileSync(path, 'utf8')) as JointTable;
}
