import { readFileSync, statSync } from 'node:fs';
import { relative, resolve } from 'node:path';
import { gunzipSync } from 'node:zlib';
import {
  type Diagnostic,
  type DiagnosticCode,
  formatDiagnostic,
  printable,
} from '../core/diagnostics.ts';
import { defaultLimits } from '../core/limits.ts';
import { readableExtensions } from '../formats/extensions.ts';
import { extensionOf, memoryFile } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { existingPath } from './existing-path.ts';
import { listFiles } from './list-files.ts';

const packedEnding = /\.gz$/i;

/** Resolves a path from the user's folder, because npm runs scripts in the project's folder. */
export function userPath(path: string): string {
  return resolve(userFolder(), path);
}

function userFolder(): string {
  return process.env['INIT_CWD'] ?? process.cwd();
}

/**
 * Reads files, including those in folders, and unpacks `.gz` files. Each file that can't be read
 * gives a diagnostic. Files that no format uses are listed without their bytes.
 */
export function readFiles(paths: readonly string[]): {
  files: FileEntry[];
  diagnostics: Diagnostic[];
} {
  const files: FileEntry[] = [];
  const diagnostics: Diagnostic[] = [];
  for (const path of paths) {
    attempt(path, () => {
      for (const each of listFiles(existingPath(userPath(path)))) {
        // Always relative to the user's folder, so that folders can be compared.
        const shown = relative(userFolder(), each);
        attempt(shown, () => files.push(readEntry(shown)));
      }
    });
  }
  return { files, diagnostics };

  function attempt(path: string, read: () => void): void {
    try {
      read();
    } catch (error) {
      diagnostics.push(unreadable(path, error));
    }
  }
}

function readEntry(path: string): FileEntry {
  const name = path.replace(packedEnding, '');
  if (!readableExtensions.includes(extensionOf(name))) return memoryFile(name, new Uint8Array(0));
  const { fileSize } = defaultLimits;
  const { size } = statSync(userPath(path));
  if (size > fileSize) throw new Error(`${size} bytes, more than ${fileSize}`);
  const bytes = readFileSync(userPath(path));
  const unpacked = name === path ? bytes : gunzipSync(bytes, { maxOutputLength: fileSize });
  return memoryFile(name, new Uint8Array(unpacked));
}

export function unreadable(path: string, error: unknown): Diagnostic {
  return failure('file/missing', path, 'a file that can be read', 'the file is not used', error);
}

export function unwritable(path: string, error: unknown): Diagnostic {
  return failure(
    'file/unwritable',
    path,
    'a file that can be written',
    'nothing is written',
    error,
  );
}

function failure(
  code: DiagnosticCode,
  file: string,
  expected: string,
  effect: string,
  error: unknown,
): Diagnostic {
  return { severity: 'error', code, file, expected, found: reasonOf(error), effect };
}

/** The system's short code, such as "ENOENT", if there is one. */
function reasonOf(error: unknown): string {
  if (!(error instanceof Error)) return String(error);
  return 'code' in error ? String(error.code) : error.message;
}

/** Prints one line per diagnostic to stderr. */
export function printDiagnostics(diagnostics: readonly Diagnostic[]): void {
  for (const diagnostic of diagnostics) {
    const effect = printable(diagnostic.effect, 200); // it may name files
    console.error(`${diagnostic.severity}: ${formatDiagnostic(diagnostic)}; ${effect}`);
  }
}
