import { zipSync } from 'fflate';
import { expect, it } from 'vitest';
import { savedFiles } from '../../src/formats/saved-files.ts';
import { loadWriter } from '../../src/formats/registry.ts';
import { legMorph, legRig, legSkel, legSkin } from '../support/cse169-files.ts';
import { readContents, readOne } from '../support/files.ts';

/** Every file of a character is saved, and what is saved is read again. */
async function saved(rigName: string, texture: string) {
  const character = await readOne({
    'leg.rig': legRig.replace('rig leg', `rig ${rigName}`),
    'leg.skel': legSkel,
    'leg.skin': legSkin.replace('leg.bmp', texture),
    'bent.morph': legMorph,
    'x/leg.bmp': Uint8Array.of(7),
  });
  const write = await loadWriter('cse169');
  return savedFiles(write(character).files, character.images);
}

it.each([
  ['../../evil', '..\\..\\x\\leg.bmp', '.._.._evil', 'x/leg.bmp'],
  ['/etc/passwd', '/etc/x/leg.bmp', '_etc_passwd', 'etc/x/leg.bmp'],
  ['C:\\evil', 'C:\\x\\leg.bmp', 'C__evil', 'x/leg.bmp'],
  ['a//b', 'x//leg.bmp', 'a__b', 'x/leg.bmp'],
  ['a\u0001\u202eb', 'leg.bmp', 'a__b', 'leg.bmp'],
  ['nul', 'x/./leg.bmp', '_nul', 'x/leg.bmp'],
])('a name %j and an image %j become plain paths', async (rigName, texture, name, image) => {
  const files = await saved(rigName, texture);
  expect(files.map(({ path }) => path)).toEqual([
    `${name}.skel`,
    `${name}.skin`,
    'bent.morph',
    image,
  ]);
  const archive = zipSync(Object.fromEntries(files.map(({ path, bytes }) => [path, bytes])));
  const { characters } = await readContents({ 'a.zip': archive });
  expect(characters).toMatchObject([
    {
      character: { name, skeleton: { jointCount: 3 }, missing: [], images: [{}] },
    },
  ]);
});

it('two files are never at one path', () => {
  const bytes = new Uint8Array(0);
  const paths = ['a:b', 'a?b', 'A*B'].map((name) => ({ path: `${name}.morph`, bytes }));
  const images = [{ name: 'a_b.morph', textures: [], bytes }];
  expect(savedFiles(paths, images).map(({ path }) => path)).toEqual([
    'a_b.morph',
    'a_b (2).morph',
    'A_B (3).morph',
    'a_b (4).morph',
  ]);
});
