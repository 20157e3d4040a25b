import { loadPart } from '../../core/failure.ts';
import { baseName, extensionOf, pathStem } from '../file-entry.ts';
import type { FileEntry, FileGroup } from '../format.ts';
import type { PartKinds } from './draft.ts';

/**
 * Groups the files of each character by their names and folders. One character in one folder, the
 * usual case and that of the first picture, does not need the full rule.
 *
 * @param byCompanions groups files among which there are some of the kinds that a character may
 *   have many of; by names and folders if absent
 */
export async function groupFiles(
  files: readonly FileEntry[],
  kinds: PartKinds,
  byCompanions?: (files: readonly FileEntry[]) => Promise<readonly FileGroup[]>,
): Promise<readonly FileGroup[]> {
  const [stems, endings] = [
    new Set(files.map(({ path }) => pathStem(path))),
    new Set(files.map(({ path }) => extensionOf(path))),
  ];
  if (stems.size === 1 && endings.size === files.length) {
    return [{ name: baseName([...stems][0]!), files, diagnostics: [] }];
  }
  if (byCompanions && files.some(({ path }) => kinds.many.includes(extensionOf(path)))) {
    return byCompanions(files);
  }
  const { groupParts } = await loadPart(import('./group-parts.ts'));
  return groupParts(files, kinds);
}
