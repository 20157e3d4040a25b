import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { defaultLimits } from '../../../src/core/limits.ts';
import { readCarefulMtl } from '../../../src/formats/obj/careful-mtl.ts';
import { readMtl } from '../../../src/formats/obj/read-mtl.ts';
import { shown } from '../../support/diagnose.ts';
import { bytesOf, type FileContents, readContents, readOne } from '../../support/files.ts';

const obj = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl skin\nf 1 2 3\n';

function read(text: string) {
  return readMtl('a.mtl', bytesOf(text));
}

async function warned(text: string): Promise<readonly string[]> {
  return shown((await read(text)).diagnostics);
}

describe('a material library', () => {
  it('gives the colors and textures of its materials', async () => {
    const { value, diagnostics } = await read(
      'newmtl skin\nillum 2\nKd 0.5 0.25 1\nKs 0.1 0.2 0.3\nKa 0 0 1\nNs 20\nd 0.5\n' +
        '# a comment\n\nnewmtl cloth of gold\nmap_Kd -s 2 2 1 -o 0.5 -clamp on my cloth.png\n' +
        'newmtl gray\nKd 0.5\nTr 0.25\n',
    );
    expect(diagnostics).toEqual([]);
    const none = { specular: [0, 0, 0], ambient: [0, 0, 0], shininess: 0 };
    expect(value).toEqual([
      {
        name: 'skin',
        colors: {
          diffuse: [0.5, 0.25, 1],
          shown: [0.5, 0.25, 1],
          specular: [0.1, 0.2, 0.3],
          ambient: [0, 0, 1],
          shininess: 20,
          alpha: 0.5,
        },
      },
      { name: 'cloth of gold', texture: 'my cloth.png' },
      {
        name: 'gray',
        colors: { ...none, diffuse: [0.5, 0.5, 0.5], shown: [0.5, 0.5, 0.5], alpha: 0.75 },
      },
    ]);
  });

  it('reads plain lines and careful ones alike', async () => {
    const line = fc.oneof(
      fc.constantFrom('newmtl a', 'newmtl eye rims', 'newmtl b1', 'newmtl 1', 'Kd 1', 'Ns', 'Kd'),
      fc.constantFrom('Kd .5 0.25 1', 'Ks 0 0 .125', 'Ns 60', 'Ns 1e3', 'Ks a b c', 'Ns a', ''),
      fc.constantFrom('Kd 1 2 3 4', 'Ns 1 2 3', 'd 0.5', 'newmtl', 'Kd 1  2 3', 'Kd . . .'),
    );
    await fc.assert(
      fc.asyncProperty(fc.array(line, { maxLength: 8 }), async (lines) => {
        const bytes = bytesOf(`newmtl first\n${lines.join('\n')}\n`);
        const careful = readCarefulMtl('a.mtl', bytes, defaultLimits);
        expect(await readMtl('a.mtl', bytes)).toEqual(careful);
      }),
      { numRuns: 500 },
    );
  });

  it('leaves out lines that are wrong, and says where', async () => {
    const text = 'Kd 1 1 1\nnewmtl a\nKd 1 red 1\nKd 1 1 1e9\nd 1.5\nNs\nmap_Kd\nglow 1\nglow 2\n';
    expect(await warned(text)).toEqual([
      'warning: a.mtl:1:1: expected "newmtl" before the properties of a material, found "Kd" ' +
        '[mtl/token]; the line is left out',
      'warning: a.mtl:3: expected three numbers for red, green and blue, found "1 red 1" ' +
        '[mtl/number]; the line is left out',
      'warning: a.mtl:4: expected three numbers for red, green and blue, found "1 1 1e9" ' +
        '[mtl/number]; the line is left out',
      'warning: a.mtl:5: expected an opacity from 0 to 1, found "1.5" [mtl/number]; ' +
        'the line is left out',
      'warning: a.mtl:6: expected an exponent, found "" [mtl/number]; the line is left out',
      'warning: a.mtl:7: expected the name of an image, found "" [mtl/number]; ' +
        'the line is left out',
      'warning: a.mtl:8:1: expected a property of a material, found "glow" [mtl/unknown]; ' +
        'such lines are left out',
    ]);
    expect((await read(text)).value).toEqual([{ name: 'a' }]);
    expect(await warned('# nothing\n')).toEqual([
      'warning: a.mtl: expected at least one "newmtl", found "none" [mtl/empty]; ' +
        'the file gives no color',
    ]);
  });
});

describe('the materials of an OBJ', () => {
  const red = 'newmtl skin\nKd 1 0 0\n';
  const blue = 'newmtl skin\nKd 0 0 1\n';

  async function diffuseOf(files: FileContents) {
    const { materials } = await readOne(files);
    return materials.map(({ colors }) => colors?.diffuse);
  }

  it('come from the library that it names, whatever that is called', async () => {
    const files = { 'x/a.obj': `mtllib ../my red.mtl\n${obj}`, 'my red.mtl': red };
    const { characters, diagnostics } = await readContents(files);
    expect(diagnostics).toEqual([]);
    expect(characters[0]!.character.materials).toHaveLength(1);
    expect(characters[0]!.files.map(({ path }) => path)).toEqual(['x/a.obj', 'my red.mtl']);
  });

  it('come from several libraries, which one line may name', async () => {
    const text = `mtllib red.mtl blue.mtl\n${obj}`;
    const files = { 'red.mtl': red, 'a.obj': text, 'blue.mtl': blue };
    expect(await diffuseOf(files)).toEqual([
      [1, 0, 0],
      [0, 0, 1],
    ]);
  });

  it('come from a library of its name if it names none', async () => {
    expect(await diffuseOf({ 'a.obj': obj, 'a.mtl': red })).toEqual([[1, 0, 0]]);
    const two = { 'a.obj': obj, 'a.mtl': red, 'b.obj': obj, 'b.mtl': blue };
    const { characters } = await readContents(two);
    const colors = characters.map(({ character }) => character.materials[0]!.colors?.diffuse);
    expect(colors).toEqual([
      [1, 0, 0],
      [0, 0, 1],
    ]);
  });

  it('may be shared by several meshes', async () => {
    const text = `mtllib red.mtl\n${obj}`;
    const { characters } = await readContents({ 'a.obj': text, 'b.obj': text, 'red.mtl': red });
    expect(characters.map(({ character }) => character.materials.length)).toEqual([1, 1]);
  });

  it('are plain without their library, with a message', async () => {
    const text = `mtllib red.mtl\n${obj}`;
    const { diagnostics } = await readContents({ 'a.obj': text });
    expect(shown(diagnostics)).toEqual([
      'warning: a.obj:1:1: expected the material library among the files, ' +
        'found "mtllib red.mtl" [obj/missing]; the surface is plain',
    ]);
  });

  it('show the texture that the library names', async () => {
    const image = new Uint8Array([1, 2, 3]);
    const { images } = await readOne({
      'a.obj': `mtllib a.mtl\n${obj}`,
      'a.mtl': 'newmtl skin\nmap_Kd a.png\n',
      'a.png': image,
    });
    expect(images).toMatchObject([{ name: 'a.png', bytes: image }]);
  });

  it('need an OBJ', async () => {
    const { characters, diagnostics } = await readContents({ 'a.mtl': red });
    expect(characters).toEqual([]);
    expect(shown(diagnostics)).toEqual([
      'warning: a.mtl: expected a .skel and an .obj with it, found "materials alone" ' +
        '[file/missing]; there is nothing to show',
    ]);
  });
});
