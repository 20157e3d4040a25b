import type { Diagnostic } from '../../core/diagnostics.ts';
import { baseName } from '../file-entry.ts';
import type { FileEntry } from '../format.ts';
import type { Found } from './find-named.ts';

/** Says so where the name in a file means several files just as well; nothing where it does not. */
export function ambiguousName(
  from: FileEntry,
  name: string,
  { file, others }: Found,
): Diagnostic[] {
  if (others.length === 0) return [];
  return [
    {
      severity: 'warning',
      code: 'file/pairing',
      file: baseName(from.path),
      expected: `one "${baseName(name)}" that is nearest, as ${file.path}`,
      found: others.map(({ path }) => path).join(', '),
      effect: `${file.path} is used, the first by path`,
    },
  ];
}
