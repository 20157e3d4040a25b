import { describe, expect, it } from 'vitest';
import { groupFiles } from '../../../src/formats/belonging/group-files.ts';
import { groupParts } from '../../../src/formats/belonging/group-parts.ts';
import { memoryFile } from '../../../src/formats/file-entry.ts';

const mit = { single: ['.skel', '.obj', '.attach'], many: [] };
const cse169 = { single: ['.rig', '.skel', '.skin'], many: ['.morph', '.anim'] };

function group(kinds: typeof cse169, ...paths: string[]) {
  const files = paths.map((path) => memoryFile(path, new Uint8Array(0)));
  return groupParts(files, kinds).map((each) => ({
    name: each.name,
    paths: each.files.map(({ path }) => path),
    notes: each.diagnostics.map(({ code, found, effect }) => `${code}: ${found}: ${effect}`),
  }));
}

it.each([[['a.skel']], [['x/a.skel', 'x/a.obj']], [['a.obj', 'b.obj']], [['a.skel', 'x/a.obj']]])(
  'is left out only where it changes nothing: %j',
  async (paths) => {
    const files = paths.map((path) => memoryFile(path, new Uint8Array(0)));
    expect(await groupFiles(files, mit)).toEqual(groupParts(files, mit));
  },
);

/** The files of each character, and whether there was a message about it. */
function outcome(...paths: string[]): string[] {
  return group(cse169, ...paths).map(({ paths: own, notes }) => {
    return [...own, ...(notes.length > 0 ? ['told'] : [])].join(' ');
  });
}

describe('the parts of a character, by their names', () => {
  it.each([
    [['a.skel', 'a.obj', 'a.attach']],
    [['a.attach', 'a.skel', 'a.obj']],
    [['A.OBJ', 'a.Skel', 'a.attach']],
    [['data/a.obj', 'data/a.skel']],
    [['data\\a.obj', 'data/a.skel']],
    [['ガ.skel'.normalize('NFD'), 'ガ.obj'.normalize('NFC')]],
    [['a.skel']],
  ])('are together: %j', (paths) => {
    const groups = group(mit, ...paths);
    expect(groups).toMatchObject([{ paths, notes: [] }]);
  });

  it('keep two characters apart, in whatever order their files come', () => {
    expect(group(mit, 'b.obj', 'a.skel', 'b.skel', 'a.obj')).toEqual([
      { name: 'b', paths: ['b.obj', 'b.skel'], notes: [] },
      { name: 'a', paths: ['a.skel', 'a.obj'], notes: [] },
    ]);
  });

  it.each([
    [
      ['man.obj', 'rig.skel'],
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
  ])('are joined where each is alone of its kind, which is told: %j', (paths, sorted) => {
    const effect = `${sorted.join(' and ')} are read as one character`;
    expect(group(mit, ...paths)).toEqual([
      {
        name: sorted[0]!.split('.')[0],
        paths,
        notes: [`file/pairing: ${sorted.slice(1).join(', ')}: ${effect}`],
      },
    ]);
  });

  it('are not guessed if a kind occurs twice', () => {
    expect(group(mit, 'a.obj', 'b.obj', 'c.skel')).toHaveLength(3);
  });

  it('are reported if two differ only in case, and none is lost', () => {
    const groups = group(mit, 'a.skel', 'A.OBJ', 'a.obj');
    expect(groups.map(({ paths }) => paths)).toEqual([['a.skel', 'A.OBJ'], ['a.obj']]);
    expect(groups[0]!.notes).toEqual([
      'file/pairing: a.obj: it is read with A.OBJ, the first by path',
    ]);
  });

  it('are empty without files', () => {
    expect(group(mit)).toEqual([]);
  });

  it('are grouped quickly even for ten thousand files', () => {
    const paths = Array.from({ length: 5000 }, (_, i) => [`a/${i}/x.skel`, `b/${i}/x.skin`]).flat();
    const names = Array.from({ length: 5000 }, (_, i) => [`a/n${i}.skel`, `b/n${i}_2.skin`]).flat();
    expect(group(cse169, ...names)).toHaveLength(5000);
    expect(group(cse169, ...paths.slice(0, 400))).toHaveLength(200);
  });
});

describe('the parts of a character, by their folders', () => {
  it.each<[string, string[], string[]]>([
    [
      'two of one name each in its own folder',
      ['x/a.skel', 'y/a.skel', 'x/a.skin', 'y/a.skin'],
      ['x/a.skel x/a.skin', 'y/a.skel y/a.skin'],
    ],
    [
      'folders by kind',
      ['s/a.skel', 's/b.skel', 'm/a.skin', 'm/b.skin'],
      ['s/a.skel m/a.skin told', 's/b.skel m/b.skin told'],
    ],
    [
      'what has its mate at hand is not taken from afar',
      ['P1/a.skel', 'P3/a.skel', 'P3/a.skin'],
      ['P1/a.skel', 'P3/a.skel P3/a.skin'],
    ],
    [
      'the nearest folder',
      ['x/rig/a.skel', 'x/mesh/a.skin', 'y/rig/a.skel', 'y/mesh/a.skin'],
      ['x/rig/a.skel x/mesh/a.skin told', 'y/rig/a.skel y/mesh/a.skin told'],
    ],
    [
      'folders of one name, where they are as near',
      ['s/x/a.skel', 's/y/a.skel', 'm/y/a.skin'],
      ['s/x/a.skel', 's/y/a.skel m/y/a.skin told'],
    ],
    [
      'the first by path of two that are as near',
      ['q/a.skel', 'p/a.skel', 'm/a.skin'],
      ['q/a.skel', 'p/a.skel m/a.skin told'],
    ],
    [
      'a name before the beginning of one',
      ['x/a.skel', 'x/a_smooth.skin', 'y/a.skin'],
      ['x/a.skel y/a.skin told', 'x/a_smooth.skin'],
    ],
    [
      'the beginning of a name, the longest first',
      ['tube.skel', 'tube_old.skel', 'tube_old_smooth.skin', 'wasp.skel'],
      ['tube.skel', 'tube_old.skel tube_old_smooth.skin told', 'wasp.skel'],
    ],
    [
      'what is alone in its folder',
      ['x/rig.skel', 'x/body.skin', 'y/r.skel', 'y/b.skin'],
      ['x/rig.skel x/body.skin told', 'y/r.skel y/b.skin told'],
    ],
  ])('%s', (_, paths, groups) => {
    expect(outcome(...paths)).toEqual(groups);
  });

  it('names the files that are as near', () => {
    const [, first] = group(cse169, 'q/a.skel', 'p/a.skel', 'm/a.skin');
    expect(first!.notes[0]).toBe(
      'file/pairing: q/a.skel: it is read with p/a.skel, the first by path',
    );
  });
});

describe('kinds of which a character may have many files', () => {
  it.each<[string, string[], string[]]>([
    [
      'a clip goes with the character of its folder, not the first of the name',
      ['P1/a.skel', 'P3/a.skel', 'P3/a_walk.anim'],
      ['P1/a.skel', 'P3/a.skel P3/a_walk.anim'],
    ],
    [
      'a clip of any name goes with the only character of its folder',
      ['x/a.skel', 'x/walk.anim', 'y/b.skel', 'y/walk.anim'],
      ['x/a.skel x/walk.anim told', 'y/b.skel y/walk.anim told'],
    ],
    [
      'even where it begins with the name of another',
      ['x/a.skel', 'x/walk.anim', 'walk/walk.skel'],
      ['x/a.skel x/walk.anim told', 'walk/walk.skel'],
    ],
    [
      'folders by kind: by the longest name',
      ['s/a.skel', 's/a_old.skel', 'c/a_old_run.anim', 'c/a_run.anim', 'c/run.anim'],
      ['s/a.skel c/a_run.anim told', 's/a_old.skel c/a_old_run.anim told', 'c/run.anim'],
    ],
    [
      'the nearest folder above',
      ['x/a.skel', 'x/clips/a_walk.anim', 'y/a.skel', 'y/clips/a_walk.anim'],
      ['x/a.skel x/clips/a_walk.anim told', 'y/a.skel y/clips/a_walk.anim told'],
    ],
    [
      'the nearest folder, whatever the names',
      ['x/a.skel', 'x/clips/walk.anim', 'y/b.skel', 'y/clips/walk.anim'],
      ['x/a.skel x/clips/walk.anim told', 'y/b.skel y/clips/walk.anim told'],
    ],
    [
      'the first by path of two that are as near',
      ['p/a.skel', 'q/a.skel', 'c/a1.morph'],
      ['p/a.skel c/a1.morph told', 'q/a.skel'],
    ],
    ['the only character, whatever the names', ['a.skel', 'b.morph'], ['a.skel b.morph told']],
    ['none, where several could', ['a.skel', 'b.skel', 'c.anim'], ['a.skel', 'b.skel', 'c.anim']],
  ])('%s', (_, paths, groups) => {
    expect(outcome(...paths)).toEqual(groups);
  });

  it('are reported once per character', () => {
    const clips = Array.from({ length: 9 }, (_, i) => `clips/${i}.anim`);
    expect(group(cse169, 'a.skel', ...clips)[0]!.notes).toEqual([
      `file/pairing: ${Array.from({ length: 9 }, (_, i) => `${i}.anim`).join(', ')}: ` +
        'a.skel, clips/0.anim, clips/1.anim, clips/2.anim and 6 more are read as one character',
    ]);
  });
});
