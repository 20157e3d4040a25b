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
 * A seam: a format is a folder with a shape, a reader and a writer, and an entry here. The latter two are
 * loaded at first use, so that a page has none whose files it never meets.
 */
export interface FormatEntry {
  readonly id: FormatId;
  readonly label: string;
  readonly shape: FormatShape;
  /** Whether a file is this format's by its beginning, for endings that others have too. */
  readonly recognizes?: (file: FileEntry) => boolean;
  readonly loadReader: () => Promise<FormatReader>;
  readonly loadWriter?: () => Promise<FormatWriter>;
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
  },
] as const satisfies readonly FormatEntry[];

/** Every format that Sinew reads. */
export const formats: readonly FormatEntry[] = entries;

/** A format that is written too, so that a character can be converted to it. */
export type ConvertTarget = Extract<
  (typeof entries)[number],
  { readonly loadWriter: unknown }
>['id'];

export const convertTargets: readonly ConvertTarget[] = entries.flatMap((entry) =>
  'loadWriter' in entry ? [entry.id] : [],
);

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

/** The format whose file it is: by its ending, and where several have that, the first that knows it. */
export function formatOf(file: FileEntry): FormatId | undefined {
  const extension = extensionOf(file.path);
  const byEnding = formats.filter(({ id }) =>
    formatExtensions[id].some((each) => each === extension),
  );
  if (byEnding.length < 2) return byEnding[0]?.id;
  return (byEnding.find(({ recognizes }) => recognizes?.(file)) ?? byEnding[0]!).id;
}
