import type { Diagnostic } from '../../core/diagnostics.ts';
import { baseName } from '../file-entry.ts';
import type { FileEntry } from '../format.ts';
import { ambiguity } from './ambiguity.ts';
import type { Found } from './find-named.ts';

/** Reports that a name in a file fits several files equally well; returns nothing otherwise. */
export function ambiguousName(
  from: FileEntry,
  name: string,
  { file, others }: Found,
): Diagnostic[] {
  const paths = others.map(({ path }) => path);
  return ambiguity(from.path, paths, {
    expected: `one "${baseName(name)}" that is nearest, as ${file.path}`,
    effect: `${file.path} is used`,
  });
}
