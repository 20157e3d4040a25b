import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import type { FileContents } from './files.ts';

const folder = resolve(import.meta.dirname, '../golden');

/** Files of tests/golden, byte for byte. */
export function golden(...names: readonly string[]): FileContents {
  return Object.fromEntries(
    names.map((name) => [name, new Uint8Array(readFileSync(goldenPath(name)))]),
  );
}

function goldenPath(name: string): string {
  return resolve(folder, name);
}

export const oddities = ['oddities.skel', 'oddities.obj', 'oddities.attach'] as const;
