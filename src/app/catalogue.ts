import { Failure } from '../core/failure.ts';
import type { BundledCharacter } from '../ui/editor.ts';
import type { LooseFile } from '../workers/read-characters-task.ts';
import { fetchChecked, fetchFile } from './fetch-file.ts';

/** A line of public/data/catalogue.json; paths are relative to it. */
export interface CatalogueEntry extends BundledCharacter {
  readonly files: readonly string[];
  readonly pose?: string;
}

/** Where the app's data lies, from whatever sub-path it is served. */
const dataUrl = new URL('data/', document.baseURI);

export async function fetchCatalogue(): Promise<readonly CatalogueEntry[]> {
  const response = await fetchChecked(new URL('catalogue.json', dataUrl));
  try {
    return (await response.json()) as CatalogueEntry[];
  } catch {
    throw new Failure('The list of characters came damaged; reload the page');
  }
}

/** The character's files, its pose among them. */
export function fetchBundled(
  { files, pose }: CatalogueEntry,
  signal: AbortSignal,
): Promise<LooseFile[]> {
  const paths = pose === undefined ? files : [...files, pose];
  return Promise.all(paths.map((path) => fetchFile(new URL(path, dataUrl), signal)));
}
