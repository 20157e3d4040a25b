import { type Diagnostic, printablePath } from '../../core/diagnostics.ts';
import { baseName } from '../file-entry.ts';

/**
 * Reports that a file fits several others equally well, of which the first by path is taken.
 * Returns nothing if there is no other.
 *
 * @param path of the file that fits several others
 * @param others the paths of those that were not taken
 */
export function ambiguity(
  path: string,
  others: readonly string[],
  { expected, effect }: Pick<Diagnostic, 'expected' | 'effect'>,
): Diagnostic[] {
  if (others.length === 0) return [];
  return [
    {
      severity: 'warning',
      code: 'file/pairing',
      file: baseName(path),
      expected,
      found: others.map((other) => printablePath(other)).join(', '),
      effect: `${effect}, the first by path`,
    },
  ];
}
