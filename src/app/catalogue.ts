import { Failure } from '../core/failure.ts';
import type { BundledCharacter } from '../ui/editor.ts';
import type { LooseFile } from '../workers/read-characters-task.ts';
import { fetchChecked, fetchFile } from './fetch-file.ts';

/** An entry of public/data/catalogue.json; paths are relative to that file. */
export interface CatalogueEntry extends BundledCharacter {
  readonly files: readonly string[];
  readonly pose?: string;
}

/** The address of the app's data, whatever sub-path the app is served from. */
const dataUrl = (): URL => new URL('data/', document.baseURI);

export async function fetchCatalogue(): Promise<readonly CatalogueEntry[]> {
  const response = await fetchChecked(new URL('catalogue.json', dataUrl()));
  try {
    return (await response.json()) as CatalogueEntry[];
  } catch {
    throw new Failure('The list of characters came damaged; reload the page');
  }
}

/** Fetches the character's files, including its pose. */
export function fetchBundled(
  { files, pose }: CatalogueEntry,
  signal: AbortSignal,
): Promise<LooseFile[]> {
  const paths = pose === undefined ? files : [...files, pose];
  return Promise.all(paths.map((path) => fetchFile(new URL(path, dataUrl()), signal)));
}
