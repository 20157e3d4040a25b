import type { Diagnostic } from '../core/diagnostics.ts';

/** A loss, told as a warning. */
export function lost(file: string, expected: string, found: string, effect: string): Diagnostic {
  return { severity: 'warning', code: 'character/lost', file, expected, found, effect };
}
