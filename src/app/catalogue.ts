import { Failure } from '../core/failure.ts';
import { memoryFile } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import type { BundledCharacter } from '../ui/editor.ts';

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
): Promise<FileEntry[]> {
  const paths = pose === undefined ? files : [...files, pose];
  return Promise.all(paths.map((path) => fetchFile(new URL(path, dataUrl), signal)));
}

/** A file of the page's own origin, unpacked if it is gzipped. */
export async function fetchFile(url: URL, signal?: AbortSignal): Promise<FileEntry> {
  if (url.origin !== location.origin) {
    throw new Failure(`${url.href}: only this page's own files; download it and drop it here`);
  }
  const response = await fetchChecked(url, signal);
  const path = decodeURIComponent(url.pathname.slice(url.pathname.lastIndexOf('/') + 1));
  try {
    const bytes = new Uint8Array(await response.arrayBuffer());
    // Some servers unpack .gz files on the way, so the bytes tell, not the name.
    const packed = bytes[0] === 0x1f && bytes[1] === 0x8b;
    const unpacked = packed ? await gunzip(bytes) : bytes;
    return memoryFile(path.replace(/\.gz$/i, ''), unpacked);
  } catch {
    throw new Failure(`${path} did not come whole`);
  }
}

async function fetchChecked(url: URL, signal?: AbortSignal): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(url, signal ? { signal } : {});
  } catch {
    throw new Failure(`${url.pathname} could not be fetched`);
  }
  if (!response.ok) throw new Failure(`${url.pathname}: the server says ${response.status}`);
  return response;
}

async function gunzip(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
