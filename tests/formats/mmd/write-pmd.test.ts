import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { buildCharacter } from '../../../src/core/build-character.ts';
import type { Character } from '../../../src/core/character.ts';
import type { CharacterParts } from '../../../src/core/character-parts.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { restPose } from '../../../src/core/pose.ts';
import { convertCharacter } from '../../../src/formats/convert.ts';
import { readPmd } from '../../../src/formats/mmd/pmd.ts';
import { writeMmd } from '../../../src/formats/mmd/write-character.ts';
import { uniqueNames } from '../../../src/formats/unique-names.ts';
import { largestDifference } from '../../support/compare.ts';
import { shown } from '../../support/diagnose.ts';
import { readContents, readOne } from '../../support/files.ts';
import { mutated } from '../../support/mutations.ts';
import { noBone, pmdFile, squarePmd } from '../../support/pmd-files.ts';
import { skinnedParts } from '../../support/random-parts.ts';
import { trianglesOf } from '../../support/triangles-of.ts';

/** The bytes of the character as PMD, and all that is said to be lost. */
function write(character: Character): { bytes: Uint8Array; losses: string[] } {
  const converted = convertCharacter(character, 'mmd', restPose(character.skeleton));
  const { files, losses } = writeMmd(converted.character);
  expect(files.map(({ path }) => path)).toEqual([`${character.name}.pmd`]);
  return { bytes: files[0]!.bytes, losses: shown([...converted.losses, ...losses]) };
}

/** Writes the character, and expects that it is read again and written as the same bytes. */
async function readAgain(character: Character): Promise<Character> {
  const { bytes } = write(character);
  const again = await readOne({ [`${character.name}.pmd`]: bytes });
  const second = write(again);
  expect(second).toEqual({ bytes, losses: [] });
  return again;
}

function built(parts: CharacterParts): Character {
  return buildCharacter(parts).value!;
}

/** Two joints and a square with a seam, whose materials alternate, as MIT 6.837 has them. */
const plain = {
  'a.skel': '0 0 2 -1\n0 1 0.5 0\n',
  'a.obj':
    'v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nvt 0 0\nvt 1 0.25\nvt 0.5 1\nvn 0 0 1\n' +
    'usemtl a\nf 1/1/1 2/2/1 3/3/1\nusemtl b\nf 1/2/1 3/3/1 4/1/1\nusemtl a\nf 1/1/1 3/3/1 4/1/1\n',
  'a.attach': '1\n1\n0.5\n0\n',
};

describe('writeMmd', () => {
  it('gives the bytes of a PMD with every section', async () => {
    const square = await readOne({ 'a.pmd': squarePmd });
    expect(write(square)).toEqual({ bytes: squarePmd, losses: [] });
  });

  it('converts a character of another course: left-handed, by render vertices and by material', async () => {
    const { bytes } = write(await readOne(plain));
    const corner = { normal: [0, 0, -1], bones: [1, 1], weight: 100 } as const;
    const clay = { diffuse: [0.74, 0.72, 0.7], ambient: [0.37, 0.36, 0.35] } as const;
    const { bytes: expected, at } = pmdFile({
      name: 'a',
      comment: '',
      vertices: [
        { ...corner, position: [0, 0, -1], uv: [0, 1] },
        { ...corner, position: [1, 0, -1], uv: [1, 0.75] },
        // Half a weight is all that it has.
        { ...corner, position: [1, 1, -1], uv: [0.5, 0] },
        { ...corner, position: [0, 1, -1], uv: [0, 1], bones: [0, 0] },
        { ...corner, position: [0, 0, -1], uv: [1, 0.75] },
      ],
      indices: [0, 2, 1, 0, 3, 2, 4, 3, 2],
      materials: [
        { ...clay, count: 6 },
        { ...clay, count: 3 },
      ],
      bones: [
        { name: 'joint 00', parent: noBone, tail: 1, type: 1, head: [0, 0, -2] },
        { name: 'joint 01', parent: 0, head: [0, 1, -2.5] },
      ],
      groups: ['bones\n'],
      listed: [[1, 1]],
      last: 'english',
    });
    expect(bytes.subarray(0, at.end)).toEqual(expected);
    const toons = readPmd('a.pmd', bytes).value!.optionalImages;
    expect(toons).toHaveLength(10);
    expect([toons![0], toons![9]]).toEqual(['toon01.bmp', 'toon10.bmp']);
  });

  it('writes what it wrote again, byte by byte, for any character', async () => {
    const name = fc.string({ unit: 'grapheme', maxLength: 24 });
    const parts = fc
      .tuple(skinnedParts, fc.array(name, { minLength: 12, maxLength: 12 }), morphOf)
      .map(([found, names, morph]) => withNamesAndMorph(found, names, morph))
      .filter((found) => jointsAreInReach(built(found)));
    await fc.assert(
      fc.asyncProperty(parts, async (found) => {
        const character = built(found);
        const again = await readAgain(character);
        const { mesh, skeleton } = character;
        expect(again.mesh.positions).toEqual(mesh.positions);
        expect(again.mesh.normals).toEqual(mesh.normals);
        expect(largestDifference(again.mesh.uvs!, mesh.uvs ?? again.mesh.uvs!)).toBeLessThan(
          1e-6 * Math.max(1, ...Array.from(mesh.uvs ?? [], Math.abs)),
        );
        expect(trianglesOf(again)).toEqual(trianglesOf(character));
        expect(again.skeleton.parents).toEqual(skeleton.parents);
        expect(again.morphs.map(({ vertices, offsets }) => [vertices, offsets])).toEqual(
          character.morphs.map(({ vertices, offsets }) => [vertices, offsets]),
        );
      }),
      { numRuns: 60 },
    );
  });

  it('writes any PMD that is read so that it stays the same from then on', async () => {
    await fc.assert(
      fc.asyncProperty(mutated(squarePmd, ['1', '-2', '99', '1e9']), async (bytes) => {
        const { characters } = await readContents({ 'a.pmd': bytes });
        for (const { character } of characters) {
          const first = writeMmd(character).files[0]!.bytes;
          const again = await readOne({ 'a.pmd': first });
          expect(writeMmd(again)).toEqual({ files: [{ path: 'a.pmd', bytes: first }], losses: [] });
        }
      }),
      { numRuns: 100 },
    );
  });
});

const morphOf = fc.record({
  points: fc.uniqueArray(fc.nat(2)),
  offset: fc.tuple(
    fc.float({ noNaN: true, min: -9, max: 9 }),
    fc.constantFrom(0, 0.5),
    fc.constant(-1),
  ),
});

function withNamesAndMorph(
  parts: CharacterParts,
  names: readonly string[],
  { points, offset }: { readonly points: number[]; readonly offset: readonly number[] },
): CharacterParts {
  const { file, joints } = parts.skeleton!;
  const unique = uniqueNames(names.slice(0, joints.length));
  return {
    ...parts,
    skeleton: { file, joints: joints.map((joint, i) => ({ ...joint, name: unique[i]! })) },
    morphs: [
      {
        file,
        name: names.at(-1)!,
        points: Uint32Array.from(points),
        offsets: Float32Array.from(points.flatMap(() => offset)),
        normalPoints: new Uint32Array(0),
        normalOffsets: new Float32Array(0),
      },
    ],
  };
}

/** Whether the joints stand within the coordinates that are read. */
function jointsAreInReach({ skeleton }: Character): boolean {
  return jointMatrices(skeleton, skeleton.qRest).every((value) => Math.abs(value) <= 1e18);
}
