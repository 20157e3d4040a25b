import { Failure } from '../core/failure.ts';
import type { BundledCharacter } from '../ui/editor.ts';
import type { LooseFile } from '../workers/read-characters-task.ts';
import { fetchChecked, fetchFile } from './fetch-file.ts';

/** What public/data/catalogue.json lists; paths are relative to that file. */
export interface Catalogue {
  readonly characters: readonly CatalogueEntry[];
  readonly scenes: readonly CatalogueScene[];
}

export interface CatalogueEntry extends BundledCharacter {
  readonly files: readonly string[];
  readonly pose?: string;
  /** Files of MOTION.json, which become clips by their names after the character opened. */
  readonly motions?: readonly string[];
}

/** Bundled characters that belong together. The first one is nearest to the camera. */
export interface CatalogueScene {
  readonly id: string;
  readonly label: string;
  /** The box around all of it, in scene space. */
  readonly bounds: { readonly min: readonly number[]; readonly max: readonly number[] };
  /** In degrees. */
  readonly camera: { readonly azimuth: number; readonly elevation: number };
  readonly actors: readonly {
    /** The id of a character. */
    readonly character: string;
    readonly pose: string;
    /** On the floor, in scene units, turned about +y in radians; the scale makes sizes true. */
    readonly place: {
      readonly x: number;
      readonly z: number;
      readonly turn: number;
      readonly scale: number;
    };
  }[];
}

/** The address of the app's data, whatever sub-path the app is served from. */
export const dataUrl = (): URL => new URL('data/', document.baseURI);

export async function fetchCatalogue(): Promise<Catalogue> {
  const response = await fetchChecked(new URL('catalogue.json', dataUrl()));
  try {
    return (await response.json()) as Catalogue;
  } catch {
    throw new Failure('The list of characters came damaged; reload the page');
  }
}

/** Fetches the character's files, including its pose. */
export function fetchBundled(
  { files, pose }: Pick<CatalogueEntry, 'files' | 'pose'>,
  signal: AbortSignal,
): Promise<LooseFile[]> {
  const paths = pose === undefined ? files : [...files, pose];
  return Promise.all(paths.map((path) => fetchFile(new URL(path, dataUrl()), signal)));
}
