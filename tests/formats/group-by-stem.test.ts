import { describe, expect, it } from 'vitest';
import { memoryFile } from '../../src/formats/file-entry.ts';
import { groupByStem } from '../../src/formats/group-by-stem.ts';

const kinds = ['.skel', '.obj', '.attach'];

function group(...paths: string[]) {
  const files = paths.map((path) => memoryFile(path, new Uint8Array(0)));
  return groupByStem(files, kinds).map((each) => ({
    name: each.name,
    paths: each.files.map(({ path }) => path),
    notes: each.diagnostics.map(({ code, found, effect }) => `${code}: ${found}: ${effect}`),
  }));
}

describe('groupByStem', () => {
  it.each([
    [['a.skel', 'a.obj', 'a.attach']],
    [['a.attach', 'a.skel', 'a.obj']],
    [['A.OBJ', 'a.Skel', 'a.attach']],
    [['data/a.obj', 'data/a.skel']],
    [['a.skel']],
  ])('takes %j as one character', (paths) => {
    expect(group(...paths)).toEqual([{ name: 'a', paths, notes: [] }]);
  });

  it('keeps two characters apart, in whatever order their files come', () => {
    expect(group('b.obj', 'a.skel', 'b.skel', 'a.obj')).toEqual([
      { name: 'b', paths: ['b.obj', 'b.skel'], notes: [] },
      { name: 'a', paths: ['a.skel', 'a.obj'], notes: [] },
    ]);
  });

  it('keeps characters of one name in two folders apart', () => {
    const groups = group('x/a.skel', 'y/a.skel', 'x/a.obj', 'y/a.obj');
    expect(groups.map(({ paths }) => paths)).toEqual([
      ['x/a.skel', 'x/a.obj'],
      ['y/a.skel', 'y/a.obj'],
    ]);
  });

  it.each([
    [
      ['man.obj', 'rig.skel'],
      ['rig.skel', 'man.obj'],
    ],
    [
      ['rig.skel', 'man.obj'],
      ['rig.skel', 'man.obj'],
    ],
    [
      ['w.attach', 'man.obj', 'rig.skel'],
      ['rig.skel', 'man.obj', 'w.attach'],
    ],
    [
      ['w.attach', 'man.obj'],
      ['man.obj', 'w.attach'],
    ],
  ])('joins %j, one of each kind, and says so in any order', (paths, sorted) => {
    const effect = `${sorted.join(' and ')} are read as one character`;
    expect(group(...paths)).toEqual([
      {
        name: sorted[0]!.split('.')[0],
        paths,
        notes: [`file/pairing: ${sorted.slice(1).join(', ')}: ${effect}`],
      },
    ]);
  });

  it('does not guess where a kind comes twice', () => {
    expect(group('a.obj', 'b.obj', 'c.skel')).toHaveLength(3);
  });

  it('takes the first of two files that differ in case alone', () => {
    expect(group('a.obj', 'A.OBJ')).toEqual([
      {
        name: 'a',
        paths: ['a.obj', 'A.OBJ'],
        notes: ['file/pairing: A.OBJ: the file is not used'],
      },
    ]);
  });

  it('makes nothing of nothing', () => {
    expect(group()).toEqual([]);
  });
});
