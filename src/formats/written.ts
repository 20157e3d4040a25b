import type { Diagnostic } from '../core/diagnostics.ts';
import type { OutputFile } from './format.ts';

/** What writing gives: the files, and what of the character has no place in them. */
export interface Written {
  readonly files: readonly OutputFile[];
  readonly losses: readonly Diagnostic[];
}

/** A loss, told as a warning. */
export function lost(file: string, expected: string, found: string, effect: string): Diagnostic {
  return { severity: 'warning', code: 'character/lost', file, expected, found, effect };
}
