import { describe, expect, it } from 'vitest';
import { legAnim, legMorph, legRig, legSkel, legSkin } from '../../support/cse169-files.ts';
import { numbersAt } from '../../support/compare.ts';
import { shown } from '../../support/diagnose.ts';
import { type FileContents, readContents } from '../../support/files.ts';
import { restPose } from '../../../src/core/pose.ts';
import { restMesh } from '../../../src/skinning/rest-mesh.ts';
import { readOne } from '../../support/files.ts';

const image = new Uint8Array([0x42, 0x4d, 0, 0]);

async function read(contents: FileContents) {
  const { characters, diagnostics } = await readContents(contents);
  const shapes = characters.map(({ character, files }) => ({
    name: character.name,
    joints: character.skeleton.jointCount,
    points: character.mesh.pointCount,
    morphs: character.morphs.map(({ name }) => name),
    clips: character.clips.map(({ name }) => name),
    missing: character.missing,
    files: files.map(({ path }) => path),
  }));
  return { shapes, messages: shown(diagnostics).filter((each) => !each.includes('/unknown]')) };
}

describe('the format of CSE169', () => {
  it('groups a complete set by names, in any order, with the image that it names', async () => {
    const { shapes, messages } = await read({
      'x/LEG.BMP': image,
      'x/leg_walk.anim': legAnim,
      'x/leg1.morph': legMorph,
      'x/leg.skin': legSkin,
      'x/leg.skel': legSkel,
    });
    expect(messages).toEqual([]);
    expect(shapes).toMatchObject([
      { name: 'leg', joints: 3, points: 4, morphs: ['leg1'], clips: ['leg_walk'], missing: [] },
    ]);
    expect(shapes[0]!.files).toContain('x/LEG.BMP');
  });

  it('reads a skeleton alone or a skin alone, and lists what is missing', async () => {
    expect((await read({ 'a.skel': legSkel })).shapes).toMatchObject([
      { joints: 3, points: 0, missing: ['.skin'] },
    ]);
    const { shapes, messages } = await read({ 'a.skin': legSkin });
    expect(shapes).toMatchObject([{ joints: 0, points: 4, missing: ['.skel', 'leg.bmp'] }]);
    expect(messages).toEqual([]);
  });

  it('groups a single set whatever its names, and reports the guess', async () => {
    const { shapes, messages } = await read({
      'a.skel': legSkel,
      'b.skin': legSkin,
      'c.morph': legMorph,
      'd.anim': legAnim,
    });
    expect(shapes).toMatchObject([{ joints: 3, points: 4, morphs: ['c'], clips: ['d'] }]);
    expect(messages.filter((message) => message.includes('[file/pairing]'))).toHaveLength(1);
  });

  it('gives each of several characters its own files, the longest name first', async () => {
    const { shapes } = await read({
      'leg.skel': legSkel,
      'leg.skin': legSkin,
      'leg_old.skel': legSkel,
      'leg_old.skin': legSkin,
      'leg_old_run.anim': legAnim,
      'leg2.morph': legMorph,
      'other.anim': legAnim,
    });
    expect(shapes).toMatchObject([
      { name: 'leg', morphs: ['leg2'], clips: [] },
      { name: 'leg_old', morphs: [], clips: ['leg_old_run'] },
    ]);
  });

  it('follows a rig, in any folder and case, and reports the missing files that it names', async () => {
    const { shapes, messages } = await read({
      'rigs/leg.rig': legRig
        .replace('2', '1')
        .replace('bent.morph', 'bent.morph gone.morph')
        .replace('morphs 1', 'morphs 2'),
      'a/Leg.skel': legSkel,
      'a/leg.SKIN': legSkin,
      'b/bent.morph': legMorph,
    });
    expect(shapes).toMatchObject([{ name: 'leg', joints: 3, points: 4, morphs: ['bent'] }]);
    expect(messages).toEqual([
      'warning: leg.rig: expected "gone.morph" among the files, found "none of this name" ' +
        '[rig/missing]; the character is shown without it',
      'warning: leg.rig: expected files of one name in one folder, ' +
        'found "Leg.skel, leg.SKIN, bent.morph" [file/pairing]; rigs/leg.rig and a/Leg.skel and ' +
        'a/leg.SKIN and b/bent.morph are read as one character',
    ]);
  });

  it('never looks for a texture anywhere but among the files', async () => {
    const skin = legSkin.replace('leg.bmp', 'http://example.org/../leg.bmp');
    const { shapes } = await read({ 'a.skel': legSkel, 'a.skin': skin, 'z/leg.bmp': image });
    expect(shapes[0]!.files).toContain('z/leg.bmp');
  });

  it('uses the channels that fit, and reports how many there should be', async () => {
    const anim = legAnim
      .replace('numchannels 12', '')
      .replace(/ {2}channel \{ ext.*0\.25 flat.*\n\}/, '}');
    const { shapes, messages } = await read({ 'a.skel': legSkel, 'a.anim': anim });
    expect(shapes[0]!.clips).toEqual(['a']);
    expect(messages[0]).toContain(
      'expected 12 channels, 3 for each of 3 joints and 3 for the root',
    );
  });

  it('reports clips and morphs without a character', async () => {
    const { shapes, messages } = await read({ 'a.anim': legAnim });
    expect(shapes).toEqual([]);
    expect(messages).toEqual([
      'warning: a.anim: expected a .skel or a .skin with it, found "a.anim" [file/missing]; ' +
        'there is nothing to show',
    ]);
  });

  it('refuses a morph of vertices that the skin does not have', async () => {
    const { shapes, messages } = await read({
      'a.skel': legSkel,
      'a.skin': legSkin,
      'a.morph': 'positions 1 { 4 0 0 0 }',
    });
    expect(shapes[0]!.morphs).toEqual([]);
    expect(messages[0]).toContain('expected vertices from 0 to 3, which the skin has, found "4"');
  });

  it('moves vertices to their targets, adds several morphs, and normalizes normals', async () => {
    const other = 'positions 1 { 3 1 0 0.3 } normals 1 { 3 0 0 -2 }';
    const character = await readOne({
      'leg.skel': legSkel,
      'leg.skin': legSkin,
      'leg1.morph': legMorph,
      'leg2.morph': other,
    });
    const { q } = restPose(character.skeleton);
    const shape = (...weights: number[]) =>
      restMesh(character, { q, morphWeights: Float64Array.from(weights) });
    expect(shape(0, 0)).toBe(character.mesh);
    const { positions, normals } = shape(1, 0.5);
    const near = (found: number[], expected: number[]): void =>
      found.forEach((value, i) => expect(value).toBeCloseTo(expected[i]!, 6));
    near(numbersAt(positions, 2, 3), [0, 0.5, 0.4]);
    near(numbersAt(positions, 3, 3), [0.5, 0, 0.6]);
    near(numbersAt(normals, 2, 3), [0, 0.6, 0.8]);
    const length = Math.hypot(0.3, 0.1);
    near(numbersAt(normals, 3, 3), [0.3 / length, 0, -0.1 / length]);
  });
});
