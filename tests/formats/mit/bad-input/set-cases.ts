import { expect } from 'vitest';
import {
  all,
  type BadInput,
  skeletonOnly,
  unbound,
  whole,
  withAttach,
  withObj,
  withSkel,
  meshOnly,
} from './bad-input.ts';

const [skel, obj, attach] = ['a.skel', 'a.obj', 'a.attach'].map((name) => whole[name] as string);

/** These files of the valid character, and what is missing then. */
function some(
  title: string,
  names: readonly string[],
  left: BadInput['left'],
  missing: readonly string[],
): BadInput {
  return {
    title: `A67 ${title}`,
    files: Object.fromEntries(names.map((name) => [name, whole[name]!])),
    messages: [],
    left,
    check: (character) => expect(character.missing).toEqual(missing),
  };
}

/** A55 and A67: truncated files and incomplete sets of files. */
export const setCases: readonly BadInput[] = [
  {
    title: 'A55 skeleton cut within its last number',
    files: withSkel(skel!.slice(0, -'1\n'.length).concat('-')),
    messages: ['error: a.skel:3:7: expected -1 or the index of a joint, found "-" [skel/integer]'],
    left: meshOnly,
  },
  {
    title: 'A55 skeleton cut before its last number',
    files: withSkel(skel!.slice(0, -'1\n'.length)),
    messages: ['error: a.skel:3: expected "tx ty tz parent", found "3 fields" [skel/field-count]'],
    left: meshOnly,
  },
  {
    title: 'A55 mesh cut within a vertex',
    files: withObj(obj!.slice(0, obj!.indexOf(' 0\nf'))),
    messages: ['error: a.obj:4: expected 3 numbers, found "2" [obj/field-count]'],
    left: { ...unbound, vertices: 0, triangles: 0 },
  },
  {
    title: 'A55 mesh cut within a number, which reads well',
    files: withObj(`${obj!}v 0 0 0.12`),
    messages: [],
    left: { ...unbound, vertices: 5 },
  },
  {
    title: 'A55 mesh cut so, against its weights',
    files: { ...whole, 'a.obj': `${obj!}v 0 0 0.12` },
    messages: [
      'error: a.attach: expected 5 rows of weights, one for each vertex of a.obj, ' +
        'found "4 rows" [character/count]',
    ],
    left: { ...unbound, vertices: 5 },
  },
  {
    title: 'A55 weights cut within the last row',
    files: withAttach(attach!.slice(0, -' 0\n'.length)),
    messages: [
      'error: a.attach:4: expected 2 weights (3 joints in a.skel, less the root), ' +
        'found "1" [attach/field-count]',
    ],
    left: unbound,
  },
  {
    title: 'A55 weights cut between rows',
    files: withAttach(attach!.slice(0, -'1 0\n'.length)),
    messages: [
      'error: a.attach: expected 4 rows of weights, one for each vertex of a.obj, ' +
        'found "3 rows" [character/count]',
    ],
    left: unbound,
  },
  some('weights first', ['a.attach', 'a.obj', 'a.skel'], all, []),
  some('skeleton last', ['a.obj', 'a.attach', 'a.skel'], all, []),
  some('no weights yet', ['a.obj', 'a.skel'], unbound, ['.attach']),
  some('no mesh yet', ['a.attach', 'a.skel'], skeletonOnly, ['.obj']),
  some('no skeleton yet', ['a.attach', 'a.obj'], meshOnly, ['.skel']),
  {
    title: 'A67 weights alone',
    files: { 'a.attach': attach! },
    messages: [
      'warning: a.attach: expected a .skel and an .obj with it, found "weights alone" ' +
        '[file/missing]',
    ],
    left: null,
  },
  {
    title: 'A67 names that part, one of each kind',
    files: { 'man.obj': obj!, 'rig.skel': skel! },
    messages: [
      'warning: rig.skel: expected files of one name in one folder, found "man.obj" [file/pairing]',
    ],
    left: unbound,
  },
  {
    title: 'A67 names that differ in case and folder marks',
    files: { 'data\\A.SKEL': skel!, 'data\\a.obj': obj!, 'data\\a.Attach': attach! },
    messages: [],
    left: all,
  },
];
