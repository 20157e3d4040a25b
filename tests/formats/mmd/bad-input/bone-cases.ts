import { mat4 } from 'gl-matrix';
import { expect } from 'vitest';
import { boneFrames } from '../../../../src/core/bone-frames.ts';
import { mmdOf } from '../../../../src/formats/mmd/mmd-parts.ts';
import { noBone, pmdFile, square, squarePmd } from '../../../support/pmd-files.ts';
import {
  at,
  type BadPmd,
  boneAt,
  changed,
  meshOnly,
  nameOf,
  place,
  put,
  putFloat,
  refused,
  warned,
  whole,
} from './bad-pmd.ts';

const unskinned = { ...square, listed: [], bodies: [], springs: [], ik: [] };

/** The skeleton is lost, but the mesh is not. */
function withoutBones(title: string, bytes: Uint8Array, offset: number, message: string): BadPmd {
  return { title, bytes, messages: [`error: ${place(offset)} ${message}`], left: meshOnly };
}

function tail(title: string, bone: number, found: number | null): BadPmd {
  const bytes = put(boneAt(1) + 22, bone & 0xff, bone >> 8);
  const message = `bones from 0 to 3 as tails, found "${found!}, bone 1" [pmd/index]`;
  return warned(title, bytes, found === null ? [] : [[boneAt(1) + 22, message]], (character) =>
    expect(mmdOf(character)!.bones[1]!.tail).toBe(-1),
  );
}

/** The file with this many bones, all children of the first. */
function manyBones(count: number): Uint8Array {
  const bones = Array.from({ length: count }, (_, i) => {
    return { name: '', parent: i === 0 ? noBone : 0, head: [i, 1, 1] as const };
  });
  return changed({ ...unskinned, bones });
}

/** C52 to C64: bones and IK chains. */
export const boneCases: readonly BadPmd[] = [
  warned(
    'C52 no bones',
    changed({ ...unskinned, bones: [] }),
    [[at.bones, 'bones, found "none" [pmd/empty]']],
    undefined,
    meshOnly,
  ),
  {
    title: 'C52 neither bones nor vertices',
    bytes: changed({
      ...unskinned,
      ...{ bones: [], vertices: [], indices: [], materials: [], morphs: [], shownMorphs: [] },
    }),
    messages: [
      `warning: ${place(at.vertices + 12)} bones, found "none" [pmd/empty]`,
      `error: ${place(at.vertices + 4)} vertices or bones, found "none" [pmd/empty]`,
    ],
    left: null,
  },
  {
    title: 'C53 more bones than Sinew takes',
    bytes: manyBones(6),
    limits: { jointCount: 5 },
    messages: ['error: a.pmd: expected at most 5 joints, found "6 joints" [character/limit]'],
    left: meshOnly,
  },
  refused(
    'C53 65,535 bones',
    put(at.bones, 0xff, 0xff),
    at.bones,
    `at most ${Math.floor((squarePmd.length - at.bones - 2) / 39)} bones of 39 bytes in the ` +
      `${squarePmd.length - at.bones - 2} bytes left, found "65535" [pmd/count]`,
  ),
  refused(
    'C54 a bone too many',
    put(at.bones, 5).subarray(0, at.ik),
    at.bones,
    'at most 4 bones of 39 bytes in the 156 bytes left, found "5" [pmd/count]',
  ),
  warned('C55 two roots', squarePmd, [], ({ skeleton }) =>
    expect(skeleton.parents.filter((parent) => parent === -1)).toHaveLength(2),
  ),
  withoutBones(
    'C56 its own parent',
    put(boneAt(1) + 20, 1, 0),
    boneAt(1) + 20,
    'parents that lead to a root (-1), found "1 > 1" [character/cycle]',
  ),
  withoutBones(
    'C57 a circle of parents',
    put(boneAt(1) + 20, 2, 0),
    boneAt(1) + 20,
    'parents that lead to a root (-1), found "1 > 2 > 1" [character/cycle]',
  ),
  withoutBones(
    'C58 parent past the end',
    put(boneAt(2) + 20, 4, 0),
    boneAt(2) + 20,
    'a parent from -1 to 3, found "4" [character/parent]',
  ),
  warned(
    'C59 parent after its child',
    changed({
      bones: square.bones.map((bone, i) => (i === 0 ? { ...bone, parent: 3 } : bone)),
    }),
    [],
    (character) => {
      const { skeleton } = character;
      expect(nameOf(character, 3)).toBe('IK');
      expect(skeleton.parents[skeleton.jointOfSource[0]!]).toBe(skeleton.jointOfSource[3]);
    },
  ),
  tail('C60 its own tail', 1, 1),
  tail('C60 tail 0', 0, null),
  tail('C60 tail 0xFFFF', noBone, null),
  tail('C60 tail past the end', 4, 4),
  warned(
    'C60 a bone without length',
    changed({
      bones: square.bones.map((bone, i) => (i === 2 ? { ...bone, head: [0, 1, 2.5] } : bone)),
    }),
    [[boneAt(2) + 20, 'bones apart from their parents, found "bones 1 and 2" [pmd/coincident]']],
    ({ skeleton }) => {
      for (const { axes } of boneFrames(skeleton)) expect(mat4.determinant(axes)).toBeCloseTo(1, 9);
    },
  ),
  refused(
    'C61 NaN head',
    putFloat(boneAt(3) + 31, NaN),
    boneAt(3) + 31,
    'a position, found "NaN, bone 3" [pmd/number]',
  ),
  refused(
    'C61 head of 1e38',
    putFloat(boneAt(3) + 27, 1e38),
    boneAt(3) + 27,
    `a position within ±1e18, found "${Math.fround(1e38)}, bone 3" [pmd/range]`,
  ),
  warned('C62 type 10', put(boneAt(2) + 24, 10), [
    [boneAt(2) + 24, 'types of bones from 0 to 9, found "10, bone 2" [pmd/unknown]'],
  ]),
  warned(
    'C62 IK parent past the end',
    put(boneAt(1) + 25, 9, 0),
    [[boneAt(1) + 25, 'bones from 0 to 3 as IK parents, found "9, bone 1" [pmd/index]']],
    (character) => expect(mmdOf(character)!.bones[1]!.ikParent).toBe(-1),
  ),
  refused(
    'C63 an IK chain of 255 bones past the end',
    put(at.ik + 2 + 4, 255).subarray(0, at.display),
    at.ik + 13,
    `510 bytes for the bones of IK chain 0, found "${at.display - at.ik - 13} bytes" ` +
      '[pmd/truncated]',
  ),
  refused(
    'C63 65,535 IK chains',
    put(at.ik, 0xff, 0xff),
    at.ik,
    `at most ${Math.floor((squarePmd.length - at.ik - 2) / 11)} IK chains of 11 bytes in the ` +
      `${squarePmd.length - at.ik - 2} bytes left, found "65535" [pmd/count]`,
  ),
  warned(
    'C64 a link past the end',
    put(at.ik + 13, 4, 0),
    [[at.ik + 2, 'IK chains of bones from 0 to 3, found "4, IK chain 0" [pmd/index]']],
    (character) => expect(mmdOf(character)!.ikChains).toEqual([]),
  ),
  {
    title: 'C55 roots alone',
    bytes: pmdFile({
      ...unskinned,
      bones: square.bones.map((bone) => ({ ...bone, parent: noBone })),
    }).bytes,
    messages: [],
    left: whole,
  },
];
