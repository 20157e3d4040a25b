import type { MeshParts, SkinParts } from '../../src/core/character-parts.ts';
import type { Parsed } from '../../src/core/diagnostics.ts';
import { readSkin } from '../../src/formats/cse169/skin.ts';
import { readAttach } from '../../src/formats/mit/attach.ts';
import { readPmd } from '../../src/formats/mmd/pmd.ts';
import { readObj } from '../../src/formats/obj/read-obj.ts';

/** What a reader found. */
export interface ReadFile {
  readonly mesh?: MeshParts;
  readonly skin?: SkinParts;
}

export const readerKinds = ['obj', 'attach', 'skin', 'pmd'] as const;
export type ReaderKind = (typeof readerKinds)[number];

type Reader = (bytes: Uint8Array) => Promise<ReadFile>;
type Reading<T> = Parsed<T> | Promise<Parsed<T>>;

/** The product's readers: from bytes to the parts of a character. */
export const sinewReaders: Readonly<Record<ReaderKind, Reader>> = {
  obj: async (bytes) => ({ mesh: await valueOf(readObj('body.obj', bytes)) }),
  attach: async (bytes) => ({ skin: await valueOf(readAttach('body.attach', bytes)) }),
  skin: async (bytes) => partsOf(await valueOf(readSkin('body.skin', bytes))),
  pmd: async (bytes) => partsOf(await valueOf(readPmd('body.pmd', bytes))),
};

function partsOf({ mesh, skin }: ReadFile): ReadFile {
  return { ...(mesh && { mesh }), ...(skin && { skin }) };
}

async function valueOf<T>(reading: Reading<T>): Promise<T> {
  const { value, diagnostics } = await reading;
  if (value === undefined) throw new Error(JSON.stringify(diagnostics));
  return value;
}
