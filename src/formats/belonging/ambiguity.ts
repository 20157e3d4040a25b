import type { Diagnostic } from '../../core/diagnostics.ts';
import { baseName } from '../file-entry.ts';

/**
 * Says so where a file goes with others just as well as with the one that is taken, the first by path;
 * nothing where there are none.
 *
 * @param path of the file that goes with one of them
 * @param others their paths
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
      found: others.join(', '),
      effect: `${effect}, the first by path`,
    },
  ];
}
