import { expect } from 'vitest';
import { printable } from '../../../../src/core/diagnostics.ts';
import { mmdOf } from '../../../../src/formats/mmd/mmd-parts.ts';
import { bytesOf } from '../../../support/files.ts';
import { center, pmdFile, square, squarePmd } from '../../../support/pmd-files.ts';
import {
  at,
  type BadPmd,
  changed,
  nameOf,
  named,
  putFloat,
  refused,
  put,
  warned,
  whole,
} from './bad-pmd.ts';

function other(title: string, content: string | Uint8Array, hint: string, found: string): BadPmd {
  const expected = hint === '' ? '"Pmd"' : `"Pmd" (${hint})`;
  return refused(title, bytesOf(content), 0, `${expected}, found "${found}" [pmd/magic]`);
}

function cut(title: string, end: number, offset: number, message: string): BadPmd {
  return refused(title, squarePmd.subarray(0, end), offset, message);
}

/** A name of bone 1, and its displayed form. */
function name(title: string, bytes: readonly number[], shown: string, fileName = shown): BadPmd {
  return warned(title, named(...bytes), [], (character) => {
    expect(nameOf(character, 1)).toBe(shown);
    expect(character.skeleton.fileNames[character.skeleton.jointOfSource[1]!]).toBe(fileName);
  });
}

const archive = 'this is an archive: unpack it first';
const text = (characters: string): number[] => [...bytesOf(characters)];

/** C1 to C23: kinds of files, truncation, and names. */
export const headerCases: readonly BadPmd[] = [
  ...[0, 1, 2].map((length) =>
    cut(
      `C1 ${length} bytes`,
      length,
      0,
      `3 bytes for "Pmd", found "${length === 1 ? '1 byte' : `${length} bytes`}" [pmd/truncated]`,
    ),
  ),
  other('C2 PMX', 'PMX \0\0\0\x40', 'PMX is not supported', 'PMX'),
  other('C3 a motion', 'Vocaloid Motion Data 0002', 'this is a motion file', 'Voc'),
  other('C3 a pose', 'Vocaloid Pose Data file', 'this is a pose file', 'Voc'),
  other('C4 zip', 'PK\x03\x04', archive, 'PK\ufffd'),
  other('C4 rar', 'Rar!\x1a\x07', archive, 'Rar'),
  other('C4 gz', Uint8Array.of(0x1f, 0x8b, 8, 0), archive, '\ufffd\ufffd\ufffd'),
  other('C5 HTML', '<!DOCTYPE html><html>', 'this is a web page', '<!D'),
  other('C5 JSON', '{"joints":{}}', 'this looks like JSON', '{"j'),
  other('C5 any text', 'hello', '', 'hel'),
  refused(
    'C6 a version of the other byte order',
    put(at.version, 0x3f, 0x80, 0, 0),
    at.version,
    'version 1, found "4.6e-41" [pmd/version]',
  ),
  warned('C7 version 2', putFloat(at.version, 2), [
    [at.version, 'version 1, found "2" [pmd/version]'],
  ]),
  refused(
    'C7 version NaN',
    putFloat(at.version, NaN),
    at.version,
    'version 1, found "NaN" [pmd/version]',
  ),
  cut('C8 in the version', 5, 3, '4 bytes for the version, found "2 bytes" [pmd/truncated]'),
  cut('C9 in the name', 20, 7, `20 bytes for the model's name, found "13 bytes" [pmd/truncated]`),
  cut(
    'C10 in the comment',
    282,
    27,
    '256 bytes for the comment, found "255 bytes" [pmd/truncated]',
  ),
  cut(
    'C11 in the number of vertices',
    at.vertices + 1,
    at.vertices,
    '4 bytes for the number of vertices, found "1 byte" [pmd/truncated]',
  ),
  cut(
    'C12 in a vertex',
    at.vertices + 4 + 3 * 38 + 37,
    at.vertices,
    'at most 3 vertices of 38 bytes in the 151 bytes left, found "4" [pmd/count]',
  ),
  cut(
    'C13 in the number of indices',
    at.indices + 3,
    at.indices,
    '4 bytes for the number of indices of vertices, found "3 bytes" [pmd/truncated]',
  ),
  cut(
    'C14 in an index',
    at.materials - 1,
    at.indices,
    'at most 5 indices of vertices of 2 bytes in the 11 bytes left, found "6" [pmd/count]',
  ),
  cut(
    'C15 in the last of the IK chains',
    at.morphs - 1,
    at.morphs - 2,
    '2 bytes for the bones of IK chain 0, found "1 byte" [pmd/truncated]',
  ),
  cut(
    'C15 before the bones',
    at.bones,
    at.bones,
    '2 bytes for the number of bones, found "0 bytes" [pmd/truncated]',
  ),
  warned(
    "C16 a model's name of 20 bytes",
    changed({ name: 'abcdefghijklmnopqrst' }),
    [],
    (character) => expect(mmdOf(character)!.modelName).toBe('abcdefghijklmnopqrst'),
  ),
  name(
    'C17 a name cut within a character',
    [...text('a'.repeat(19)), 0x83],
    `${'a'.repeat(19)}\ufffd`,
  ),
  warned('C18 0xFD after the NUL', squarePmd, [], (character) => {
    expect(nameOf(character, 0)).toBe('センター');
    expect(mmdOf(character)!.modelName).toBe('センター');
  }),
  name('C19 markup', text('<script>x</script>'), '<script>x</script>'),
  warned('C19 control characters', named(0x61, 0x07, 0x1b, 0x62), [], (character) => {
    expect(printable(nameOf(character, 1))).toBe('a\ufffd\ufffdb');
  }),
  warned('C20 two bones of one name', squarePmd, [], (character) => {
    expect([1, 2].map((bone) => nameOf(character, bone))).toEqual(['ﾈｸﾀｲ', 'ﾈｸﾀｲ (2)']);
    expect(character.morphs.map((morph) => morph.name)).toEqual(['smile', 'smile (2)']);
  }),
  name('C21 no name', [], 'bone 01', ''),
  name('C22 half-width kana', [0xc8, 0xb8], 'ﾈｸ'),
  name('C22 user-defined', [0xf0, 0x40], '\ue000'),
  name('C22 0x5C and 0x7E', [0x5c, 0x7e], '\\~'),
  name('C23 UTF-8', text('骨'), '鬪ｨ'),
  {
    title: 'C18 padding of the comment',
    bytes: pmdFile({ ...square, comment: center }).bytes,
    messages: [],
    left: whole,
    check: (character) => expect(mmdOf(character)!.comment).toBe('センター'),
  },
];
