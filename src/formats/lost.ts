import type { Diagnostic } from '../core/diagnostics.ts';

/** Makes a warning about something that was lost. */
export function lost(file: string, expected: string, found: string, effect: string): Diagnostic {
  return { severity: 'warning', code: 'character/lost', file, expected, found, effect };
}
