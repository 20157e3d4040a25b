import type { DiagnosticDetails } from '../../core/diagnostics.ts';

const beginning = new TextEncoder().encode('version https://git-lfs.');

/**
 * Whether the bytes are a pointer of Git LFS: a short text that stands for a file until
 * `git lfs pull` replaces it (git-lfs, docs/spec.md).
 */
export function isLfsPointer(bytes: Uint8Array): boolean {
  return beginning.every((byte, index) => bytes[index] === byte);
}

/** The message about a pointer in place of a file. */
export const lfsPointer: Omit<DiagnosticDetails, 'effect'> = {
  code: 'file/pointer',
  expected: 'the file itself, which "git lfs pull" brings',
  found: 'a pointer of Git LFS',
};
