import { describe, expect, it } from 'vitest';
import type { Character } from '../../../src/core/character.ts';
import { defaultLimits } from '../../../src/core/limits.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { DofKind } from '../../../src/core/skeleton.ts';
import { convertCharacter } from '../../../src/formats/convert.ts';
import { mmdOf } from '../../../src/formats/mmd/mmd-parts.ts';
import { readPmd } from '../../../src/formats/mmd/pmd.ts';
import { shapeOf } from '../../../src/formats/registry.ts';
import { linearBlend } from '../../../src/skinning/linear-blend.ts';
import { skinVertices } from '../../support/skin-vertices.ts';
import { expectPosable, expectSound } from '../../support/check-character.ts';
import { largestDifference, numbersAt } from '../../support/compare.ts';
import { readContents, readOne } from '../../support/files.ts';
import { pmdFile, square, squarePmd } from '../../support/pmd-files.ts';

const { at } = pmdFile(square);

function read(): Promise<Character> {
  return readOne({ 'Square.PMD': squarePmd });
}

describe('readPmd', () => {
  it('converts the mesh to the right-handed space, with its triangles still facing outwards', async () => {
    const character = await read();
    expectSound(character);
    expectPosable(character);
    const { mesh, meta, name, missing } = character;
    expect([name, meta.fileSpace, missing]).toEqual(['Square', 'left-handed', ['A.bmp']]);
    expect([...mesh.positions]).toEqual([-1, 0, -2, 1, 0, -2, 1, 2, -2, -1, 2, -2]);
    expect([...mesh.indices]).toEqual([0, 1, 2, 0, 2, 3]);
    const normals = [0, 1, 2, 3].map((point) => numbersAt(mesh.normals, point, 3));
    const slanted = [0, Math.fround(0.6), Math.fround(0.8)];
    expect(normals).toEqual([[0, 0, 1], [0, 0, 1], slanted, [0, 0, 1]]);
    // v counts upwards from the lower edge of the image.
    expect([...mesh.uvs!]).toEqual([0, 0, 1, 0, 1, 1, -0.25, 1]);
    expect(Object.is(mesh.positions[1], -0)).toBe(false);
  });

  it('gives each material its triangles, images and colors, and what its program shows of them', async () => {
    const { materials, mesh } = await read();
    const light = 154 / 255; // that of MikuMikuDance
    expect(materials).toEqual([
      {
        name: 'material 00',
        texture: 'A.bmp',
        sphere: { texture: 'b.spa', blend: 'add' },
        colors: {
          diffuse: [0.25, 0.5, 0.75],
          alpha: 0.5,
          shininess: 8,
          specular: [0.125, 0.25, 0.375],
          ambient: [0.5, 0.25, 0.125],
          shown: [0.5 + light * 0.25, 0.25 + light * 0.5, 0.125 + light * 0.75],
        },
        toon: 3,
        hasEdge: true,
        twoSided: true,
      },
      {
        name: 'material 01',
        sphere: { texture: 'c.sph', blend: 'multiply' },
        colors: {
          diffuse: [1, 1, 1],
          alpha: 1,
          shininess: 5,
          specular: [0, 0, 0],
          ambient: [0.5, 0.5, 0.5],
          shown: [0.5 + light, 0.5 + light, 0.5 + light],
        },
        toon: -1,
        hasEdge: false,
        twoSided: false,
      },
    ]);
    expect(mesh.submeshes).toEqual([
      { material: 'material 00', firstIndex: 0, indexCount: 3 },
      { material: 'material 01', firstIndex: 3, indexCount: 3 },
    ]);
  });

  it('makes a joint of each bone, movable where the file says so and at every root', async () => {
    const { skeleton } = await read();
    expect(skeleton.names).toEqual(['センター', 'ﾈｸﾀｲ', 'ﾈｸﾀｲ (2)', 'IK']);
    expect(skeleton.fileNames).toEqual(['センター', 'ﾈｸﾀｲ', 'ﾈｸﾀｲ', 'IK']);
    expect([...skeleton.parents]).toEqual([-1, 0, 1, -1]);
    expect([...skeleton.restOffsets]).toEqual([0, 0, -2, 0, 1, -0.5, 0.5, 1, 1.5, 0.5, 2, -1]);
    const { slide, ball } = DofKind;
    const movable = [slide, slide, slide, ball];
    expect([...skeleton.dofKind]).toEqual([...movable, ball, ball, ...movable]);
    const child = square.bones.map((bone, i) => (i === 2 ? { ...bone, type: 1 } : bone));
    const other = await readOne({ 'a.pmd': pmdFile({ ...square, bones: child }).bytes });
    expect([...other.skeleton.dofKind]).toEqual([...movable, ball, ...movable, ...movable]);
  });

  it('has weights by joint, and follows the joints', async () => {
    const character = await read();
    const { skin, skeleton, mesh } = character;
    expect([...skin.start]).toEqual([0, 1, 3, 5, 6]);
    expect([...skin.entries]).toEqual([0, 0, 1, 1, 2, 2]);
    const weights = [1, 0.25, 0.75, 0.7, 0.3, 1];
    expect(largestDifference(skin.weights, weights)).toBeLessThan(1e-7);
    const q = skeleton.qRest.slice();
    q.set([1, 2, 3], 0); // the slides of the first root
    const moved = skinVertices(character, skin, { q }, linearBlend).positions;
    const wanted = mesh.positions.map((value, i) => value + [1, 2, 3][i % 3]!);
    expect(largestDifference(moved, wanted)).toBeLessThan(1e-6);
    expect([...jointMatrices(skeleton, q).subarray(12, 15)]).toEqual([1, 2, 1]);
  });

  it('maps morphs to the vertices of the base', async () => {
    const character = await read();
    expect(
      character.morphs.map(({ name, vertices, offsets }) => [name, [...vertices], [...offsets]]),
    ).toEqual([
      ['smile', [1], [0.5, 0.25, -0.125]],
      ['smile (2)', [], []],
    ]);
    expect(mmdOf(character)!.morphs).toEqual({
      basePoints: Uint32Array.of(3, 1),
      basePositions: Float32Array.of(-1, 2, -2, 1, 0, -2),
      listed: [
        { fileName: 'base', panel: 0, morph: -1 },
        { fileName: 'smile', panel: 3, morph: 0 },
        { fileName: 'smile', panel: 2, morph: 1 },
      ],
    });
  });

  it.each([1e30, Infinity])(
    'holds a morph that hides a part by a move of %d, which then stands far off',
    async (hidden) => {
      const [base, smile] = square.morphs!;
      const hides = { ...smile!, entries: [[1, [0, -hidden, 0.5]]] as const };
      const bytes = pmdFile({ ...square, morphs: [base!, hides], shownMorphs: [1] }).bytes;
      const { characters, diagnostics } = await readContents({ 'Square.PMD': bytes });
      const { character } = characters[0]!;
      expect(diagnostics.filter(({ code }) => code === 'pmd/index')).toEqual([]);
      const [morph] = character.morphs;
      const far = Math.fround(defaultLimits.coordinate);
      expect([...morph!.offsets]).toEqual([0, -far, -0.5]);
      const q = character.skeleton.qRest;
      const pose = { q, morphWeights: Float64Array.of(1) };
      const posed = skinVertices(character, character.skin, pose, linearBlend);
      expect(posed.positions.every(Number.isFinite)).toBe(true);
      expect(posed.positions[morph!.vertices[0]! * 3 + 1]).toBeLessThan(-0.9 * far);
    },
  );

  it('keeps the data that motions and writers need, also after a transfer between threads', async () => {
    const mmd = mmdOf(structuredClone(await read()));
    expect(mmd).toMatchObject({
      version: 1,
      modelName: 'センター',
      comment: 'a comment',
      bones: [
        { type: 1, tail: 1, ikParent: 0 },
        { type: 4, tail: 2, ikParent: 3 },
        { type: 6, tail: -1, ikParent: 0 },
        { type: 2, tail: -1, ikParent: 0 },
      ],
      ikChains: [{ goal: 3, effector: 2, iterations: 40, limit: 0.5, links: [1] }],
      display: {
        morphs: [2, 1],
        groupNames: ['body', 'legs'],
        bones: [
          { bone: 1, group: 1 },
          { bone: 3, group: 2 },
        ],
      },
      english: {
        modelName: 'Model',
        comment: 'A comment',
        boneNames: ['bone-0', 'bone-1', 'bone-2', 'bone-3'],
        morphNames: ['morph-0', 'morph-1'],
        groupNames: ['group-0', 'group-1'],
      },
    });
    expect(mmd!.toons).toHaveLength(10);
    expect(mmd!.vertices.edgeFlags).toEqual(Uint8Array.of(0, 1, 0, 0));
    expect(mmd!.vertices.weights).toEqual(Uint8Array.of(100, 25, 70, 30));
    expect(mmd!.vertices.bones).toEqual(Uint16Array.of(0, 1, 0, 1, 1, 2, 2, 2));
    expect([...mmd!.vertices.normals.subarray(9)]).toEqual([0, 0, 2]);
  });

  it('mirrors physics too: a lower bound in z becomes an upper one', async () => {
    const { bodies, joints } = mmdOf(await read())!.physics!;
    const single = (values: readonly number[]): number[] => values.map(Math.fround);
    expect(bodies.map(({ bone, shape }) => [bone, shape])).toEqual([
      [1, 'capsule'],
      [-1, 'box'],
    ]);
    expect(bodies[0]).toMatchObject({
      ...{ name: 'body', group: 3, mask: 0xfffe, size: [1, 2, 3], position: [4, 5, -6] },
      ...{ rotation: single([-0.1, -0.2, 0.3]), mass: 1, friction: 0.5, mode: 1 },
    });
    expect(joints).toEqual([
      {
        ...{ name: 'spring', bodies: [0, 1], position: [1, 2, -3] },
        rotation: single([-0.1, -0.2, 0.3]),
        ...{ positionMin: [-1, -2, -6], positionMax: [4, 5, 3] },
        rotationMin: single([-0.4, -0.5, -0.3]),
        rotationMax: single([0.1, 0.2, 0.6]),
        ...{ positionSpring: [7, 8, 9], rotationSpring: [1, 2, 3] },
      },
    ]);
  });

  it('finds its images in any folder and in any case, those of toons too', async () => {
    const image = Uint8Array.of(0);
    const { characters, diagnostics } = await readContents({
      'm/a.pmd': squarePmd,
      'm/tex/a.BMP': image,
      'toon/Toon4.bmp': image,
      'm/other.tga': image,
    });
    const { files, character } = characters[0]!;
    expect(files.map(({ path }) => path)).toEqual(['m/a.pmd', 'm/tex/a.BMP', 'toon/Toon4.bmp']);
    expect(character.missing).toEqual([]);
    expect(diagnostics.map(({ file, effect }) => [file, effect])).toEqual([
      ['a.pmd', 'm/tex/a.BMP is used, by name'],
      ['other.tga', 'the file is not used'],
    ]);
  });

  it('reports where a file is cut, at every byte, and reads what comes before', () => {
    const soundEnds = [at.english, at.toons, at.physics];
    for (let end = 0; end < squarePmd.length; end++) {
      const { value, diagnostics } = readPmd('a.pmd', squarePmd.subarray(0, end));
      if (soundEnds.includes(end)) {
        expect([value !== undefined, diagnostics.length]).toEqual([true, 0]);
        continue;
      }
      expect(diagnostics).toHaveLength(1);
      const [{ severity, code, offset }] = diagnostics as [(typeof diagnostics)[number]];
      expect(severity).toBe(end < at.morphs ? 'error' : 'warning');
      expect(['pmd/truncated', 'pmd/count']).toContain(code);
      expect(offset).toBeLessThanOrEqual(end);
      expect(value === undefined).toBe(end < at.morphs);
    }
  });

  it('reads a file that lies within a larger buffer', () => {
    const buffer = new Uint8Array(squarePmd.length + 5);
    buffer.set(squarePmd, 5);
    expect(readPmd('a.pmd', buffer.subarray(5))).toEqual(readPmd('a.pmd', squarePmd));
  });

  it('keeps to the limits, and reads what is at them', () => {
    const few = { pointCount: 4, triangleCount: 2, jointCount: 4 };
    const within = (changed: Partial<typeof few>) =>
      readPmd('a.pmd', squarePmd, { ...defaultLimits, ...few, ...changed });
    expect(within({}).diagnostics).toEqual([]);
    expect(within({ pointCount: 3 }).diagnostics[0]).toMatchObject({
      code: 'pmd/limit',
      found: '4',
    });
    expect(within({ triangleCount: 1 }).diagnostics[0]).toMatchObject({ code: 'pmd/limit' });
  });
});

describe('a PMD in the files of the courses', () => {
  it.each(['mit', 'cse169'] as const)('looks the same in a pose: %s', async (to) => {
    const character = await read();
    const { skeleton, skin } = character;
    const q = skeleton.qRest.slice();
    q.set([0.5, 0, 1, 0, Math.sin(0.3), 0, Math.cos(0.3)], 0);
    q.set([Math.sin(0.4), 0, 0, Math.cos(0.4)], 7);
    const converted = convertCharacter(character, to, { q });
    const old = skinVertices(character, skin, { q }, linearBlend).positions;
    const { character: other, pose } = converted;
    const now = skinVertices(other, other.skin, pose, linearBlend).positions;
    expect(largestDifference(now, old)).toBeLessThan(1e-5);
    const names = other.morphs.map(({ name }) => name);
    expect(names).toEqual(to === 'mit' ? [] : character.morphs.map(({ name }) => name));
    const lost = converted.losses.map(({ found }) => found);
    expect(lost).toContain('IK chains, lists, physics and names in English');
    expect(lost.includes('colors of materials')).toBe(!shapeOf(to).colors);
  });
});
