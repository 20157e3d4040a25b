import { existsSync, readFileSync } from 'node:fs';
import { basename, resolve } from 'node:path';
import { describe, it } from 'vitest';
import type { FileContents } from '../support/files.ts';

/** Real course files and reference results, in a folder next to the project if it exists. */
const shared = resolve(import.meta.dirname, '../../../shared');

/**
 * A suite that reads this material. If the folder is missing, the suite is skipped and its name
 * says why. Its body is not even collected, because it may read files while it names its tests.
 */
export function describeWithShared(
  title: string,
  paths: readonly string[],
  body: () => void,
): void {
  const absent = paths.find((path) => !existsSync(resolve(shared, path)));
  if (absent === undefined) {
    describe(title, body);
  } else {
    const skipped = `${title} (skipped: ../shared/${absent} is not there)`;
    process.stdout.write(`${skipped}\n`); // reporters do not name skipped suites
    it.skip(skipped, () => undefined);
  }
}

export function sharedPath(path: string): string {
  return resolve(shared, path);
}

export function sharedBytes(path: string): Uint8Array {
  return new Uint8Array(readFileSync(resolve(shared, path)));
}

export function sharedJson(path: string): unknown {
  return JSON.parse(new TextDecoder().decode(sharedBytes(path)));
}

/** Little-endian float32. */
export function sharedFloats(path: string): Float32Array {
  const bytes = sharedBytes(path);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  return Float32Array.from({ length: bytes.length / 4 }, (_, i) => view.getFloat32(i * 4, true));
}

/** The `.skel`, `.obj` and `.attach` of a model of 6.837. */
export function modelFiles(model: string): FileContents {
  const paths = ['.skel', '.obj', '.attach'].map((ending) => `data/mit-6837/${model}${ending}`);
  return Object.fromEntries(paths.map((path) => [basename(path), sharedBytes(path)]));
}

/** Files of a folder, under their own names. */
export function sharedFiles(folder: string, ...names: readonly string[]): FileContents {
  return Object.fromEntries(names.map((name) => [name, sharedBytes(`${folder}/${name}`)]));
}
