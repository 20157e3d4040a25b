import type { Character } from '../../../../src/core/character.ts';
import type { Limits } from '../../../../src/core/limits.ts';
import type { FileContents } from '../../../support/files.ts';
import {
  patched,
  type PmdContent,
  pmdFile,
  square,
  squarePmd,
} from '../../../support/pmd-files.ts';

/** A row of the table: a file, the expected messages, and what remains of the character. */
export interface BadPmd {
  /** The number and the description of the case: "C33 bone past the end". */
  readonly title: string;
  readonly bytes: Uint8Array;
  /** Other files that are opened with it. */
  readonly beside?: FileContents;
  /** Smaller limits than Sinew's own, for cases that would otherwise be large. */
  readonly limits?: Partial<Limits>;
  /** Every message, `severity: a.pmd @ byte N (0xN): expected …, found "…" [code]`. */
  readonly messages: readonly string[];
  readonly left: Left | null;
  readonly check?: (character: Character) => void;
}

export interface Left {
  readonly joints: number;
  readonly vertices: number;
  readonly triangles: number;
  readonly bound: boolean;
}

/** What remains of the valid file: everything. */
export const whole: Left = { joints: 4, vertices: 4, triangles: 2, bound: true };
export const meshOnly: Left = { ...whole, joints: 0, bound: false };
export const bonesOnly: Left = { joints: 4, vertices: 0, triangles: 0, bound: false };

/** Where the sections of the valid file start. */
export const { at } = pmdFile(square);

/** The bytes of a record of each kind. */
const size = { vertex: 38, material: 70, bone: 39, body: 83, spring: 124 } as const;

/** Where a record of the valid file starts, after the section's count. */
export function vertexAt(index: number): number {
  return at.vertices + 4 + index * size.vertex;
}

export function materialAt(index: number): number {
  return at.materials + 4 + index * size.material;
}

export function boneAt(index: number): number {
  return at.bones + 2 + index * size.bone;
}

export function place(offset: number): string {
  return `a.pmd @ byte ${offset} (0x${offset.toString(16)}): expected`;
}

/** An error at a place; nothing remains. */
export function refused(
  title: string,
  bytes: Uint8Array,
  offset: number,
  message: string,
  limits: Partial<Limits> = {},
): BadPmd {
  return { title, bytes, limits, messages: [`error: ${place(offset)} ${message}`], left: null };
}

/** Warnings, and what remains: usually everything. */
export function warned(
  title: string,
  bytes: Uint8Array,
  warnings: readonly (readonly [offset: number, message: string])[],
  check?: (character: Character) => void,
  left: Left = whole,
): BadPmd {
  const messages = warnings.map(([offset, message]) => `warning: ${place(offset)} ${message}`);
  return { title, bytes, messages, left, ...(check ? { check } : {}) };
}

/** The valid file with other bytes at a place. */
export function put(offset: number, ...bytes: readonly number[]): Uint8Array {
  return patched(squarePmd, offset, bytes);
}

export function putFloat(offset: number, value: number): Uint8Array {
  const word = new Uint8Array(4);
  new DataView(word.buffer).setFloat32(0, value, true);
  return put(offset, ...word);
}

export function putCount(offset: number, value: number): Uint8Array {
  const word = new Uint8Array(4);
  new DataView(word.buffer).setUint32(0, value, true);
  return put(offset, ...word);
}

/** The valid content with some parts replaced. */
export function changed(content: Partial<PmdContent>): Uint8Array {
  return pmdFile({ ...square, ...content }).bytes;
}

/** A name field that starts with these bytes. */
export function named(...bytes: readonly number[]): Uint8Array {
  return changed({
    bones: square.bones.map((bone, i) => (i === 1 ? { ...bone, name: bytes } : bone)),
  });
}

/** The name of the joint that is bone `index` of the file. */
export function nameOf({ skeleton }: Character, index: number): string {
  return skeleton.names[skeleton.jointOfSource[index]!]!;
}
