import { describe, expect, it } from 'vitest';
import { buildCharacter } from '../../../src/core/build-character.ts';
import type { Character } from '../../../src/core/character.ts';
import type { MaterialParts } from '../../../src/core/character-parts.ts';
import { restPose } from '../../../src/core/pose.ts';
import { convertCharacter } from '../../../src/formats/convert.ts';
import { readTextures } from '../../../src/formats/mmd/texture-field.ts';
import { writeMmd } from '../../../src/formats/mmd/write-character.ts';
import { withMorph } from '../../fixtures/with-morph.ts';
import { leg } from '../../support/cse169-files.ts';
import { shown } from '../../support/diagnose.ts';
import { readContents, readOne } from '../../support/files.ts';
import { pmdFile, square, squarePmd } from '../../support/pmd-files.ts';

const files = {
  'a.skel': '0 0 0 -1\n0 1 0 0\n0 1 0 1\n0 1 0 2\n',
  'a.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n',
  'a.attach': '1 0 0\n0.5 0.5 0\n0 0.25 0.75\n',
};

/** Converts, writes and reads again; with what was said to be lost. */
async function through(character: Character) {
  const { skeleton } = character;
  const converted = convertCharacter(character, 'mmd', restPose(skeleton));
  const { files, losses } = writeMmd(converted.character);
  const again = await readOne({ 'a.pmd': files[0]!.bytes });
  return { again, losses: shown([...converted.losses, ...losses]) };
}

async function lossesOf(character: Character): Promise<string[]> {
  return (await through(character)).losses;
}

const loss = (expected: string, found: string, effect: string, file = 'a.pmd'): string =>
  `warning: ${file}: expected ${expected}, found "${found}" [pmd/lost]; ${effect}`;

describe('what writing a PMD loses', () => {
  it('is nothing for a character that it can hold', async () => {
    expect(await lossesOf(await readOne(files))).toEqual([]);
    expect(await lossesOf(await readOne({ 'a.pmd': squarePmd }))).toEqual([]);
    expect(await lossesOf(await readOne({ 'a.skel': files['a.skel'] }))).toEqual([]);
  });

  it('is told of weights: how many vertices have more than two, and the largest part left out', async () => {
    const attach = '0.5 0.25 0.25\n0.5 0.375 0.125\n1 0 0\n';
    const { again, losses } = await through(await readOne({ ...files, 'a.attach': attach }));
    expect(losses).toEqual([
      'warning: a: expected what the files of MikuMikuDance can hold, ' +
        'found "2 vertices of over 2 influences" [character/lost]; ' +
        'each keeps its largest weights, divided by their sum; up to 25 % of its weights are left out',
      loss(
        'weights in hundredths that sum to 1',
        'others, for 2 vertices',
        'they are rounded; a weight changes by at most 0.0033',
      ),
    ]);
    expect(again.skin.weights.map((weight) => Math.round(weight * 100))).toEqual(
      Float32Array.of(67, 33, 57, 43, 100),
    );
  });

  it('is told of weights that a PMD does not have: other sums, and negative ones', async () => {
    const attach = '0.5 0 0\n1.25 -0.25 0\n0.997 0.003 0\n';
    const { again, losses } = await through(await readOne({ ...files, 'a.attach': attach }));
    expect(losses).toEqual([
      loss(
        'weights in hundredths that sum to 1',
        'others, for 3 vertices',
        'they are rounded; a weight changes by at most 0.5',
      ),
    ]);
    expect([...again.skin.entries]).toEqual([1, 1, 1]);
    expect([...again.skin.weights]).toEqual([1, 1, 1]);
  });

  it('is told of names, which stay different', async () => {
    const name = 'a leg with a long name and the rest of it';
    const words = ['a_leg_with_a_long_name', 'a_leg_with_a_long_name_too', 'né'];
    const skel = `${words.map((word) => `balljoint ${word} {`).join(' ')} } } }`;
    const { again, losses } = await through({ ...(await readOne({ 'a.skel': skel })), name });
    expect(again.skeleton.fileNames).toEqual([
      'a_leg_with_a_long_na',
      'a_leg_with_a_lon (2)',
      'n?',
    ]);
    expect(losses.filter((text) => text.includes('names'))).toEqual([
      'warning: a leg with a long name and the rest of it: expected what the files of ' +
        'MikuMikuDance can hold, found "3 names of joints" [character/lost]; ' +
        'they are cut and written in Shift-JIS',
      loss(
        'names of at most 20 bytes in Shift-JIS',
        '1 others, such as a leg with a long name…',
        'they are cut, with ? for characters that Shift-JIS does not have',
        'a leg with a long name and the rest of it.pmd',
      ),
    ]);
  });

  it('is told of normals of morphs, names of materials, boxes, limits, clips and the pose', async () => {
    const losses = (await lossesOf(await readOne(leg))).join('\n');
    for (const word of [
      ...['boxes', 'limits of 3 values', '1 clips', "the file's pose", 'bindings'],
      ...['"normals of 1"', '"names of 1"'],
    ]) {
      expect(losses).toContain(word);
    }
    expect(losses).not.toContain('morphs" [character');
  });

  it('is told of a mesh without weights, which follows the first bone', async () => {
    const skinless = await readOne({ 'a.skel': files['a.skel'], 'a.obj': files['a.obj'] });
    const { again, losses } = await through(skinless);
    expect(losses).toContain(
      loss('weights for each vertex', 'none', 'all vertices follow the first bone'),
    );
    expect([...again.skin.entries]).toEqual([0, 0, 0]);
  });

  it('is told of the data of a file whose bones could not be used', async () => {
    const bones = square.bones.map((bone, index) => ({ ...bone, parent: (index + 1) % 4 }));
    const { characters } = await readContents({ 'a.pmd': pmdFile({ ...square, bones }).bytes });
    const { character } = characters[0]!;
    expect([character.skeleton.jointCount, character.mesh.pointCount]).toEqual([0, 4]);
    const { again, losses } = await through(character);
    expect(losses).toEqual([
      loss(
        'data that fit the joints and vertices',
        'IK chains, lists, physics and names in E…',
        'left out',
      ),
    ]);
    expect(again.mesh).toEqual(character.mesh);
  });
});

describe('materials', () => {
  async function materialsAgain(...materials: readonly MaterialParts[]) {
    const { value } = buildCharacter({
      name: 'a',
      missing: [],
      mesh: {
        file: 'a',
        positions: new Float32Array(9),
        cornerPoints: Uint32Array.from(materials.flatMap(() => [0, 1, 2])),
        materials,
        submeshes: materials.map(({ name }, firstTriangle) => ({ material: name, firstTriangle })),
      },
    });
    const { again, losses } = await through(value!);
    return { materials: again.materials, losses };
  }

  it('keep their colors, toons and edges', async () => {
    const written = {
      diffuse: [0.5, 0.25, 1],
      alpha: 0.5,
      specular: [0.25, 0, 1],
      shininess: 8,
      ambient: [0.125, 0.5, 0],
    } as const;
    const colors = { ...written, shown: [1, 1, 1] } as const;
    const { materials } = await materialsAgain(
      { name: '', colors, toon: -1, hasEdge: true },
      { name: 'b', texture: 'b.png' },
    );
    expect(materials[0]).toMatchObject({ colors: written, toon: -1, hasEdge: true });
    expect(materials[0]!.texture).toBeUndefined();
    // An image is shown in its own colors.
    expect(materials[1]).toMatchObject({
      texture: 'b.png',
      colors: { diffuse: [1, 1, 1] },
      toon: 0,
      hasEdge: false,
    });
  });

  it.each([
    ['a.png', true],
    ['骨骨骨骨骨骨骨骨.png', true],
    ['骨骨骨骨骨骨骨骨骨.png', false],
    ['a long name of an image.png', false],
    ['é.png', false],
    ['a*b.png', false],
    ['a.spa', false],
  ])('have the image %s only if a file of that name can be found', async (texture, isWritten) => {
    const { materials, losses } = await materialsAgain({ name: '', texture });
    expect(materials[0]!.texture).toBe(isWritten ? texture : undefined);
    const expected = 'names of images of at most 20 bytes in Shift-JIS';
    const wanted = loss(expected, 'others, for 1 materials', 'left out');
    expect(losses).toEqual(isWritten ? [] : [wanted]);
  });

  it('have their sphere map in the same field', async () => {
    for (const field of ['a.bmp*b.spa', 'b.sph', '']) {
      const { materials } = await materialsAgain({ name: '', ...readTextures(field) });
      expect(materials[0]).toMatchObject(readTextures(field));
    }
  });
});

describe('a mesh with many vertices', () => {
  function pointsAlone(count: number): Character {
    return buildCharacter({
      name: 'a',
      missing: [],
      mesh: {
        file: 'a',
        positions: new Float32Array(count * 3),
        cornerPoints: Uint32Array.of(0, 1, count - 1),
      },
    }).value!;
  }

  it('is written if its triangles can number them', async () => {
    const { again } = await through(pointsAlone(65_535));
    expect([...again.mesh.indices]).toEqual([0, 1, 65_534]);
  });

  it('is refused otherwise, with the reason and without a file', () => {
    const { files, losses } = writeMmd(pointsAlone(65_536));
    expect(files).toEqual([]);
    expect(shown(losses)).toEqual([
      'error: a.pmd: expected at most 65535 vertices, as many as its triangles can number, ' +
        'found "65536" [pmd/limit]; nothing is written',
    ]);
  });
});

it('a morph moves the vertices of both sides of a seam', async () => {
  const seam = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 2/2 3/2\n';
  const character = withMorph(await readOne({ ...files, 'a.obj': seam }));
  expect(character.mesh.vertexCount).toBe(6);
  const { again } = await through(character);
  const [morph] = again.morphs;
  expect([morph!.name, [...morph!.vertices].sort()]).toEqual(['larger', [0, 1, 3, 4]]);
});
