import { describe, expect, it } from 'vitest';
import { shown } from '../../support/diagnose.ts';
import { type FileContents, readContents } from '../../support/files.ts';

const skel = '0 0 0 -1\n0 1 0 0\n0 1 0 1\n';
const obj = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
const attach = '1 0\n0.5 0.5\n0 1\n';

async function read(contents: FileContents) {
  const { characters, diagnostics } = await readContents(contents);
  const sizes = characters.map(({ character }) => ({
    name: character.name,
    joints: character.skeleton.jointCount,
    points: character.mesh.pointCount,
    missing: character.missing,
    bound: character.skin.jointFromBind.length === character.skeleton.jointCount * 16,
  }));
  return { sizes, messages: shown(diagnostics) };
}

const whole = { name: 'a', joints: 3, points: 3, missing: [], bound: true };

describe('the format of 6.837', () => {
  it('reads three files as one character', async () => {
    const contents = { 'a.attach': attach, 'a.obj': obj, 'a.skel': skel };
    expect(await read(contents)).toEqual({ sizes: [whole], messages: [] });
  });

  it('shows the parts that exist and lists the missing ones', async () => {
    const alone = { name: 'a', joints: 0, points: 3, missing: ['.skel', '.attach'], bound: false };
    expect(await read({ 'a.obj': obj })).toEqual({ sizes: [alone], messages: [] });
    const skeleton = { ...whole, points: 0, missing: ['.obj', '.attach'], bound: false };
    expect(await read({ 'a.skel': skel })).toEqual({ sizes: [skeleton], messages: [] });
    expect(await read({ 'a.attach': attach })).toEqual({
      sizes: [],
      messages: [
        'warning: a.attach: expected a .skel and an .obj with it, found "weights alone" ' +
          '[file/missing]; there is nothing to show',
      ],
    });
  });

  it.each([
    [
      'more columns than joints',
      '1 0 0\n'.repeat(3),
      'a.attach:1: expected 2 weights (3 joints in a.skel, less the root), found "3" ' +
        '[attach/field-count]',
    ],
    [
      'a row too few',
      '1 0\n0 1\n',
      'a.attach: expected 3 rows of weights, one for each vertex of a.obj, found "2 rows" ' +
        '[character/count]',
    ],
  ])('shows mesh and skeleton where the weights have %s', async (_, weights, message) => {
    const { sizes, messages } = await read({ 'a.skel': skel, 'a.obj': obj, 'a.attach': weights });
    expect(sizes).toEqual([{ ...whole, bound: false }]);
    expect(messages).toEqual([`error: ${message}; the mesh is shown without its weights`]);
  });

  it('shows the mesh where the skeleton has an error', async () => {
    const contents = { 'a.skel': '0 0 0 1\n0 0 0 0\n0 0 0 -1', 'a.obj': obj, 'a.attach': attach };
    const { sizes, messages } = await read(contents);
    expect(sizes).toMatchObject([{ joints: 0, points: 3 }]);
    expect(messages.at(-1)).toContain('a.skel:1:7: expected parents that lead to a root (-1)');
  });

  it('reports wrong columns before a missing row', async () => {
    const { messages } = await read({ 'a.skel': skel, 'a.obj': obj, 'a.attach': '1\n1\n' });
    expect(messages).toHaveLength(1);
  });

  it("leaves the other course's .skel and unknown files to others", async () => {
    const { sizes, messages } = await read({
      'b.skel': 'balljoint root { }',
      'a.obj': obj,
      'readme.txt': '',
    });
    expect(sizes).toMatchObject([
      { name: 'a', joints: 0 },
      { name: 'b', joints: 1, missing: ['.skin'] },
    ]);
    expect(messages).toHaveLength(2);
    expect(messages[0]).toContain('warning: a.obj: expected a .skel of MIT 6.837, found');
    expect(messages[1]).toContain('warning: readme.txt: expected files that Sinew reads (.skel, ');
  });

  it('reads two characters at once', async () => {
    const contents = { 'a.obj': obj, 'b.skel': skel, 'a.skel': skel, 'b.obj': obj };
    const { sizes } = await read(contents);
    expect(sizes.map(({ name }) => name)).toEqual(['a', 'b']);
  });
});
