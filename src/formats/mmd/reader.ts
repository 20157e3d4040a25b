import type { CharacterParts } from '../../core/character-parts.ts';
import type { Parsed } from '../../core/diagnostics.ts';
import type { Limits } from '../../core/limits.ts';
import { groupFiles } from '../belonging/group-files.ts';
import { baseName } from '../file-entry.ts';
import type { FileGroup, FormatReader } from '../format.ts';
import { readPmd } from './pmd.ts';

/**
 * MikuMikuDance: each `.pmd` is one character; the images that it names are searched for among the
 * other files.
 */
export const mmdReader: FormatReader = {
  group: (files) => groupFiles(files, { single: ['.pmd'], many: [] }),
  read: readGroup,
};

async function readGroup(
  { name, files }: FileGroup,
  limits: Limits,
): Promise<Parsed<CharacterParts>> {
  const [file] = files;
  const { value, diagnostics } = readPmd(baseName(file!.path), await file!.bytes(), limits);
  return { ...(value ? { value: { name, missing: [], ...value } } : {}), diagnostics };
}
