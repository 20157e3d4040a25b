import { assert } from '../core/assert.ts';
import { loadPart } from '../core/failure.ts';
import { formatExtensions } from './extensions.ts';
import { isCse169File } from './cse169/recognize.ts';
import { cse169Shape } from './cse169/shape.ts';
import { extensionOf } from './file-entry.ts';
import type { FileEntry, FormatReader, FormatShape, FormatWriter } from './format.ts';
import { isMitFile } from './mit/recognize.ts';
import { mitShape } from './mit/shape.ts';
import { mmdShape } from './mmd/shape.ts';

/**
 * A format consists of a folder with a shape, a reader and optionally a writer, and an entry here.
 * The reader and the writer are loaded at first use, so that a page does not load code for files
 * that it never opens.
 */
export interface FormatEntry {
  readonly id: FormatId;
  readonly label: string;
  readonly shape: FormatShape;
  /**
   * Decides by the beginning of a file whether it is of this format, for extensions that other
   * formats use too.
   */
  readonly recognizes?: (file: FileEntry) => boolean;
  readonly loadReader: () => Promise<FormatReader>;
  readonly loadWriter?: () => Promise<FormatWriter>;
  /** What `convert --to` and the names of archives call the written files; the id if absent. */
  readonly writtenAs?: string;
}

export type FormatId = keyof typeof formatExtensions;

const entries = [
  {
    id: 'mit',
    label: 'MIT 6.837',
    shape: mitShape,
    recognizes: isMitFile,
    loadReader: async () => (await loadPart(import('./mit/reader.ts'))).mitReader,
    loadWriter: async () => (await loadPart(import('./mit/write-character.ts'))).writeMit,
  },
  {
    id: 'cse169',
    label: 'UCSD CSE169',
    shape: cse169Shape,
    recognizes: isCse169File,
    loadReader: async () => (await loadPart(import('./cse169/reader.ts'))).cse169Reader,
    loadWriter: async () => (await loadPart(import('./cse169/write-character.ts'))).writeCse169,
  },
  {
    id: 'mmd',
    label: 'MikuMikuDance',
    shape: mmdShape,
    loadReader: async () => (await loadPart(import('./mmd/reader.ts'))).mmdReader,
    loadWriter: async () => (await loadPart(import('./mmd/write-character.ts'))).writeMmd,
    writtenAs: 'pmd',
  },
] as const satisfies readonly FormatEntry[];

/** Every format that Sinew reads. */
export const formats: readonly FormatEntry[] = entries;

/** A format that can be written, so that a character can be converted to it. */
export type ConvertTarget = Extract<
  (typeof entries)[number],
  { readonly loadWriter: unknown }
>['id'];

export const convertTargets: readonly ConvertTarget[] = entries.flatMap((entry) =>
  'loadWriter' in entry ? [entry.id] : [],
);

/** The word for a format that can be written, on the command line and in names of archives. */
export function writtenWord(id: ConvertTarget): string {
  return formats.find((each) => each.id === id)!.writtenAs ?? id;
}

export function labelOf(id: FormatId): string {
  return formats.find((each) => each.id === id)!.label;
}

export function shapeOf(id: FormatId): FormatShape {
  return formats.find((each) => each.id === id)!.shape;
}

/** The writer of a format that has one. */
export async function loadWriter(id: FormatId): Promise<FormatWriter> {
  const load = formats.find((each) => each.id === id)?.loadWriter;
  assert(load !== undefined, `a format that is written, found ${id}`);
  return load();
}

/**
 * The format of a file: by its extension and, if several formats use that, the first that
 * recognizes it.
 */
export function formatOf(file: FileEntry): FormatId | undefined {
  const extension = extensionOf(file.path);
  const byEnding = formats.filter(({ id }) =>
    formatExtensions[id].some((each) => each === extension),
  );
  if (byEnding.length < 2) return byEnding[0]?.id;
  return (byEnding.find(({ recognizes }) => recognizes?.(file)) ?? byEnding[0]!).id;
}
