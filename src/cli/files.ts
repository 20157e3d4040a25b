import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { type Diagnostic, formatDiagnostic, printable } from '../core/diagnostics.ts';
import { memoryFile } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';

/** npm runs scripts in the project's folder; paths are meant from where the user stands. */
export function userPath(path: string): string {
  return resolve(process.env['INIT_CWD'] ?? process.cwd(), path);
}

/** The files, with a diagnostic for each that can't be read; `.gz` ones are unpacked. */
export function readFiles(paths: readonly string[]): {
  files: FileEntry[];
  diagnostics: Diagnostic[];
} {
  const files: FileEntry[] = [];
  const diagnostics: Diagnostic[] = [];
  for (const path of paths) {
    try {
      const bytes = readFileSync(userPath(path));
      files.push(
        path.endsWith('.gz')
          ? memoryFile(path.slice(0, -3), new Uint8Array(gunzipSync(bytes)))
          : memoryFile(path, new Uint8Array(bytes)),
      );
    } catch (error) {
      diagnostics.push(unreadable(path, error));
    }
  }
  return { files, diagnostics };
}

export function unreadable(path: string, error: unknown): Diagnostic {
  return {
    severity: 'error',
    code: 'file/missing',
    file: path,
    expected: 'a file that can be read',
    found: error instanceof Error && 'code' in error ? String(error.code) : String(error),
    effect: 'the file is not used',
  };
}

/** One line each, to stderr. */
export function printDiagnostics(diagnostics: readonly Diagnostic[]): void {
  for (const diagnostic of diagnostics) {
    const effect = printable(diagnostic.effect, 200); // it may name files
    console.error(`${diagnostic.severity}: ${formatDiagnostic(diagnostic)}; ${effect}`);
  }
}
