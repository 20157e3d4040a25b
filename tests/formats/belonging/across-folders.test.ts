import { describe, expect, it } from 'vitest';
import { legAnim, legMorph, legRig, legSkel, legSkin } from '../../support/cse169-files.ts';
import { type FileContents, readContents } from '../../support/files.ts';
import { pmdFile } from '../../support/pmd-files.ts';
import { zipOf } from '../../support/zip.ts';

const skel = '0 0 0 -1\n0 1 0 0\n';
const obj = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
const attach = '1\n1\n1\n';

/** The files and the messages of each character. */
async function read(contents: FileContents) {
  const { characters, diagnostics } = await readContents(contents);
  const shapes = characters.map(({ character }) => {
    const { name, skeleton, mesh, skin, morphs, clips, images, missing } = character;
    return [
      `${name}: ${skeleton.jointCount} joints, ${mesh.pointCount} points`,
      ...(skin.jointFromBind.length > 16 ? ['weights'] : []),
      ...morphs.map((each) => each.name),
      ...clips.map((each) => each.name),
      ...images.map(({ name: image, bytes }) => `${image} = ${bytes.join()}`),
      ...missing.map((each) => `without ${each}`),
    ].join(', ');
  });
  const ofFiles = diagnostics.filter(({ code }) => code.startsWith('file/'));
  return { shapes, messages: ofFiles.map(({ file, code }) => `${file} ${code}`) };
}

/** A PMD with a triangle for each of the textures. */
function pmdWith(...textures: (string | readonly number[])[]): Uint8Array {
  return pmdFile({
    vertices: [[0, 0, 0] as const, [1, 0, 0] as const, [0, 1, 0] as const].map((position) => ({
      position,
    })),
    indices: textures.flatMap(() => [0, 1, 2]),
    materials: textures.map((texture) => ({ count: 3, texture })),
    bones: [{ name: 'root', parent: 0xffff, head: [0, 0, 0] }],
  }).bytes;
}

/** An image that is identified by its only byte. */
const image = (byte: number): Uint8Array => Uint8Array.of(byte);

describe('characters whose files lie in several folders', () => {
  it('come together from folders by kind', async () => {
    const { shapes, messages } = await read({
      'all/skeletons/wasp.skel': legSkel,
      'all/skeletons/tube.skel': legSkel,
      'all/skins/wasp.skin': legSkin,
      'all/skins/tube.skin': legSkin.replace('leg.bmp', 'tube.bmp'),
      'all/animations/wasp_walk.anim': legAnim,
      'all/morphs/tube1.morph': legMorph,
      'all/textures/leg.bmp': image(1),
      'all/textures/tube.bmp': image(2),
    });
    expect(shapes).toEqual([
      'wasp: 3 joints, 4 points, weights, wasp_walk, leg.bmp = 1',
      'tube: 3 joints, 4 points, weights, tube1, tube.bmp = 2',
    ]);
    expect(messages).toEqual([
      ...['wasp.skel file/pairing', 'wasp.skin file/pairing'],
      ...['tube.skel file/pairing', 'tube.skin file/pairing'],
    ]);
  });

  it('come together from folders by kind for the other course too', async () => {
    const { shapes } = await read({
      'skel/a.skel': skel,
      'skel/b.skel': skel,
      'mesh/a.obj': obj,
      'mesh/b.obj': obj,
      'weights/a.attach': attach,
      'weights/b.attach': attach,
    });
    expect(shapes).toEqual(['a: 2 joints, 3 points, weights', 'b: 2 joints, 3 points, weights']);
  });

  it('keep their clips, morphs and images, where others have the same names', async () => {
    const { shapes, messages } = await read({
      'P1/wasp.skel': legSkel,
      'P3/wasp.skel': legSkel,
      'P3/wasp.skin': legSkin,
      'P3/wasp_walk.anim': legAnim,
      'P4/wasp.skel': legSkel,
      'P4/wasp.skin': legSkin,
      'P4/wasp1.morph': legMorph,
      'P3/leg.bmp': image(3),
      'P4/leg.bmp': image(4),
    });
    expect(shapes).toEqual([
      'wasp: 3 joints, 0 points, without .skin',
      'wasp: 3 joints, 4 points, weights, wasp_walk, leg.bmp = 3',
      'wasp: 3 joints, 4 points, weights, wasp1, leg.bmp = 4',
    ]);
    expect(messages).toEqual([]);
  });

  it('follow the paths of their rigs', async () => {
    const named = (folder: string): string =>
      legRig.replace(/leg\.s/g, `${folder}\\leg.s`).replace('bent', `..\\rigs\\${folder}/bent`);
    const { shapes, messages } = await read({
      'rigs/a.rig': named('A').replace('rig leg', 'rig a'),
      'rigs/b.rig': named('B').replace('rig leg', 'rig b'),
      'rigs/A/leg.skel': legSkel,
      'rigs/A/leg.skin': legSkin.replace('leg.bmp', 'x.bmp'),
      'rigs/A/bent.morph': legMorph,
      'rigs/B/leg.skel': legSkel.replace('joint end { offset 1 2 3 }', ''),
      'rigs/B/leg.skin': legSkin.replace('leg.bmp', 'y.bmp'),
      'rigs/B/bent.morph': legMorph,
    });
    expect(shapes).toEqual([
      'a: 3 joints, 4 points, weights, bent, without x.bmp',
      'b: 3 joints, 4 points, weights, bent, without y.bmp',
    ]);
    expect(messages).toEqual([]);
  });

  it('follow a rig of any length', async () => {
    const morphs = Array.from({ length: 400 }, (_, i) => `a_morph_of_some_length_${i}.morph`);
    const { shapes } = await read({
      'r.rig': `rig r { skeleton x.skel skin y.skin morphs 400 { ${morphs.join(' ')} } }`,
      'x.skel': legSkel,
      'y.skin': legSkin,
      [morphs[399]!]: legMorph,
    });
    expect(shapes).toEqual([
      'r: 3 joints, 4 points, weights, a_morph_of_some_length_399, without leg.bmp',
    ]);
  });

  it('take each image from the path that its material names', async () => {
    const { shapes, messages } = await read({
      'm/a.pmd': pmdWith('face\\t.bmp', 'hair/t.bmp', 'D:\\x\\hair\\t.bmp', '..\\up.bmp'),
      'm/face/t.bmp': image(1),
      'm/hair/t.bmp': image(2),
      'up.bmp': image(3),
      'm/x/up.bmp': image(4),
    });
    expect(shapes).toEqual([
      'a: 1 joints, 3 points, weights, face/t.bmp = 1, hair/t.bmp = 2, x/hair/t.bmp = 2, up.bmp = 3'.replace(
        ', weights',
        '',
      ),
    ]);
    expect(messages).toEqual(['up.bmp file/unknown']);
  });

  it('take images of the same name from their own folders', async () => {
    const { shapes, messages } = await read({
      'A/a.pmd': pmdWith('tex.bmp'),
      'A/tex.bmp': image(1),
      'B/b.pmd': pmdWith('sub\\tex.bmp'),
      'B/TEX.bmp': image(2),
    });
    expect(shapes).toEqual([
      'a: 1 joints, 3 points, tex.bmp = 1',
      'b: 1 joints, 3 points, sub/tex.bmp = 2',
    ]);
    expect(messages).toEqual([]);
  });

  it('stay separate in two archives, each of which is a folder', async () => {
    const { shapes } = await read({
      'one.zip': zipOf({ 'a.pmd': pmdWith('tex.bmp'), 'tex.bmp': image(1) }),
      'two.zip': zipOf({ 'b.pmd': pmdWith('tex.bmp'), 'tex.bmp': image(2) }),
    });
    expect(shapes).toEqual([
      'a: 1 joints, 3 points, tex.bmp = 1',
      'b: 1 joints, 3 points, tex.bmp = 2',
    ]);
  });

  it('find decomposed names of macOS', async () => {
    const ending = [0x2e, 0x62, 0x6d, 0x70]; // .bmp, after ガ in Shift-JIS
    const { shapes } = await read({
      [`${'ガ'.normalize('NFD')}/a.pmd`]: pmdWith([0x78, 0x5c, 0x83, 0x4b, ...ending]),
      [`${'ガ'.normalize('NFD')}/x/${'ガ'.normalize('NFD')}.bmp`]: image(1),
      [`${'が'.normalize('NFD')}.skel`]: skel,
      [`${'が'.normalize('NFC')}.obj`]: obj,
      ['b.skel']: skel,
    });
    expect(shapes).toContain('a: 1 joints, 3 points, x/ガ.bmp = 1');
    expect(shapes.some((each) => each.endsWith('2 joints, 3 points, without .attach'))).toBe(true);
  });
});

describe('a .skel of which course', () => {
  it.each([
    ['# {root} first\n0 0 0 -1\n', ['.obj', '.attach']],
    ['# made from a balljoint file\r\n0 0 0 -1\r\n0 1 0 0 # {tip}\r\n', ['.obj', '.attach']],
    ['// { }\n0 0 0 -1\n', ['.obj', '.attach']],
    ['0 0 0 -1\n', ['.obj', '.attach']],
    ['balljoint root { }\n', ['.skin']],
    ['/* 0 0 0 -1\n*/ BallJoint root\n{\n}', ['.skin']],
  ] as const)('%j is told from its tokens: without %j', async (text, missing) => {
    const { characters, diagnostics } = await readContents({ 'a.skel': text });
    const found = characters.map(({ character }) => character.missing);
    // The other course's comments are errors for this reader.
    if (characters.length > 0) expect(found).toEqual([missing]);
    else expect(diagnostics[0]!.effect).toBe('the skeleton is not used');
  });

  it('is the one whose mesh lies beside it where it is rich text', async () => {
    const { characters, diagnostics } = await readContents({
      'm.skel': '{\\rtf1\\ansi 0 0 0 -1\\par}',
      'm.obj': obj,
    });
    expect(characters.map(({ character }) => character.missing)).toEqual([['.attach']]);
    expect(diagnostics).toMatchObject([{ file: 'm.skel', code: 'file/rich-text' }]);
  });
});
