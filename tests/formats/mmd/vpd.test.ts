import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Character } from '../../../src/core/character.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { jointRange, type Pose } from '../../../src/core/pose.ts';
import { vpdCodec } from '../../../src/formats/mmd/vpd-codec.ts';
import { readVpd } from '../../../src/formats/mmd/vpd.ts';
import { writeVpd } from '../../../src/formats/mmd/write-vpd.ts';
import { holdsPosesOf, poseFormatOf } from '../../../src/formats/pose-formats.ts';
import { badPoses, bone, bytes, head, long, start, tie, vowel } from './bad-vpd.ts';
import { said, shown } from '../../support/diagnose.ts';
import { bytesOf, readOne } from '../../support/files.ts';
import { mutated } from '../../support/mutations.ts';
import { center, noBone, pmdFile, square } from '../../support/pmd-files.ts';
import { tolerances } from '../../tolerances.ts';

const pmd = pmdFile({
  ...square,
  bones: [
    { name: center, parent: noBone, type: 1, head: [0, 1, 0] },
    { name: head, parent: 0, head: [0, 2, 0] },
    { name: tie, parent: 1, head: [0, 2, -1] },
    { name: long.slice(0, 20), parent: 0, head: [1, 1, 0] },
  ],
  morphs: [
    { name: [...bytesOf('base')], panel: 0, entries: [[0, [-1, 0, 2]]] },
    { name: vowel, panel: 3, entries: [[0, [0, 1, 0]]] },
  ],
  shownMorphs: [1],
  ik: [],
  listed: [],
  groups: [],
  bodies: [],
  springs: [],
  last: 'toons',
}).bytes;

const character = await readOne({ 'a.pmd': pmd });

const rest = ({ skeleton, morphs }: Character): Required<Pose> => ({
  q: skeleton.qRest.slice(),
  morphWeights: new Float64Array(morphs.length),
});

/** What `vpdCodec` gives for the character at rest. */
const read = (file: Uint8Array) => vpdCodec.read('a.vpd', file, character, rest(character));

function jointNamed(name: string): number {
  return character.skeleton.fileNames.indexOf(name);
}

function valuesOf({ q }: Pose, name: string): number[] {
  return [...q.subarray(...jointRange(character.skeleton, jointNamed(name)))];
}

describe('a pose of MikuMikuDance', () => {
  it('turns and moves bones in Sinew’s right-handed space, and leaves all others as shown', () => {
    const turn = Math.SQRT1_2;
    const file = bytes(
      `${start}2;\r\n\r\nBone0{`,
      center,
      '\r\n  1.5,-2,3;\r\n  0,0,0,1;\r\n}\r\nBone1{',
      head,
      `\r\n  0,0,0;\r\n  ${turn},0,0,${turn};\r\n}\r\nMorph0{`,
      vowel,
      '\r\n  0.25;\r\n}\r\n',
    );
    const before = rest(character);
    before.q.set([0.6, 0, 0, 0.8], jointRange(character.skeleton, jointNamed('ﾈｸﾀｲ'))[1] - 4);
    const { value, diagnostics } = vpdCodec.read('a.vpd', file, character, before);
    expect(diagnostics).toEqual([]);
    expect(valuesOf(value!, 'センター')).toEqual([1.5, -2, -3, 0, 0, 0, 1]);
    expect(valuesOf(value!, '頭').slice(-4)).toEqual([-turn, 0, 0, turn]);
    expect(valuesOf(value!, 'ﾈｸﾀｲ').slice(-4)).toEqual([0.6, 0, 0, 0.8]);
    expect([...value!.morphWeights!]).toEqual([0.25]);
    // In the file's left-handed space, a quarter turn about x takes the tie from (0, 0, −1) to
    // (0, 1, 0) from the head: y′ = −z, z′ = y. Here z is negated.
    const still = vpdCodec.read('a.vpd', file, character, rest(character)).value!;
    const matrices = jointMatrices(character.skeleton, still.q);
    const place = matrices.subarray(jointNamed('ﾈｸﾀｲ') * 16 + 12).subarray(0, 3);
    const expected = [1.5, 2 - 2 + 1, -3];
    place.forEach((each, axis) =>
      expect(Math.abs(each - expected[axis]!)).toBeLessThan(tolerances.turn),
    );
  });

  it('as MikuMikuDance writes it is read and written as the same bytes', () => {
    const lines = [
      'Vocaloid Pose Data file\r\n\r\nmodel.osm;\t\t// ',
      [0x90, 0x65, 0x83, 0x74, 0x83, 0x40, 0x83, 0x43, 0x83, 0x8b, 0x96, 0xbc],
      '\r\n2;\t\t\t\t// ',
      [
        0x91, 0x8d, 0x83, 0x7c, 0x81, 0x5b, 0x83, 0x59, 0x83, 0x7b, 0x81, 0x5b, 0x83, 0x93, 0x90,
        0x94,
      ],
      '\r\n\r\nBone0{',
      center,
      '\r\n  0.000000,-1.250000,0.031250;\t\t\t\t// trans x,y,z\r\n',
      '  0.000000,0.000000,0.000000,1.000000;\t\t// Quaternion x,y,z,w\r\n}\r\n\r\nBone1{',
      tie,
      '\r\n  0.000000,0.000000,-0.000000;\t\t\t\t// trans x,y,z\r\n',
      '  0.123457,-0.300000,0.100000,0.940000;\t\t// Quaternion x,y,z,w\r\n}\r\n\r\n',
    ];
    const file = bytes(...lines);
    const { value, diagnostics } = readVpd('a.vpd', file);
    expect(diagnostics).toEqual([]);
    expect(Buffer.from(writeVpd(value!))).toEqual(Buffer.from(file));
  });

  it('of any bones and morphs is read again with the same bits', () => {
    const number = fc.double({ min: -1e6, max: 1e6, noNaN: true });
    const name = fc
      .stringMatching(/^[a-z0-9頭左右腕ひざﾈｸﾀｲ＿{}]{1,12}$/)
      .filter((each) => each.trim() === each);
    const bones = fc.array(
      fc.record({
        name,
        line: fc.constant(0),
        position: fc.tuple(number, number, number),
        rotation: fc.tuple(number, number, number, number),
      }),
    );
    const morphs = fc.array(fc.record({ name, line: fc.constant(0), weight: number }));
    fc.assert(
      fc.property(bones, morphs, (ofBones, ofMorphs) => {
        const vpd = { model: '初音ミク.osm', bones: ofBones, morphs: ofMorphs };
        const { value } = readVpd('a.vpd', writeVpd(vpd));
        const bare = (all: readonly { readonly line: number }[]) =>
          all.map((each) => ({ ...each, line: 0 }));
        expect({ ...value, bones: bare(value!.bones), morphs: bare(value!.morphs) }).toEqual(vpd);
      }),
      { numRuns: 60 },
    );
  });

  it('of a whole character brings its pose back', () => {
    const { skeleton } = character;
    fc.assert(
      fc.property(
        fc.array(fc.double({ min: -1, max: 1, noNaN: true }), {
          minLength: skeleton.qRest.length,
          maxLength: skeleton.qRest.length,
        }),
        (numbers) => {
          // Adding 0 turns −0 into 0, which mirroring a space does too.
          const q = Float64Array.from(numbers, (each) => each + 0);
          for (let joint = 0; joint < skeleton.jointCount; joint++) {
            const [, to] = jointRange(skeleton, joint);
            const length = Math.hypot(...q.subarray(to - 4, to));
            if (length < 0.1) q.set([0, 0, 0, 1], to - 4);
            else for (let i = to - 4; i < to; i++) q[i]! /= length;
          }
          const pose = { q, morphWeights: Float64Array.of(0.1 + 0.2) };
          const { files, losses } = vpdCodec.write(character, pose);
          const again = read(files[0]!.bytes);
          expect(files[0]!.path).toBe('a.vpd');
          // The name that the PMD cut within a character has no place in a text.
          expect([losses.length, again.diagnostics.map(({ code }) => code)]).toEqual([
            0,
            ['vpd/encoding'],
          ]);
          expect(again.value!.morphWeights).toEqual(pose.morphWeights);
          again.value!.q.forEach((each, i) => expect(Math.abs(each - q[i]!)).toBeLessThan(1e-15));
        },
      ),
      { numRuns: 40 },
    );
  });

  it('is offered for characters whose joints are balls, and for no others', async () => {
    const vpd = poseFormatOf('x/POSE.VPD')!;
    const arm = { 'a.skel': '0 0 0 -1\n0 1 0 0\n', 'a.obj': 'v 0 1 0\n', 'a.attach': '1\n' };
    expect([vpd.id, holdsPosesOf(vpd, character), holdsPosesOf(vpd, await readOne(arm))]).toEqual([
      'vpd',
      true,
      false,
    ]);
  });

  it('says which names other programs do not find again', () => {
    const names = ['腕', 'gân', 'gân', '//'];
    const renamed = {
      ...character,
      skeleton: { ...character.skeleton, names, fileNames: names },
    };
    const { losses } = vpdCodec.write(renamed, rest(character));
    expect(said(losses)).toEqual([
      'warning: a.vpd: expected names of bones in Shift-JIS, found "gân and 2 more" [character/lost]',
      'warning: a.vpd: expected a name of its own for each of the bones, found "gân" [character/lost]',
    ]);
  });

  it('never throws and never poses beyond numbers, whatever the bytes are', () => {
    const good = bytes(`${start}2;\r\n`, ...bone(center), ...bone(head));
    fc.assert(
      fc.property(mutated(good, ['nan', '1e400', '-', ';', '}']), (file) => {
        const { value, diagnostics } = read(file);
        expect(value !== undefined || diagnostics.length > 0).toBe(true);
        if (value) expect(value.q.every(Number.isFinite)).toBe(true);
      }),
      { numRuns: 300 },
    );
  });
});

describe('bad poses of MikuMikuDance', () => {
  it.each(badPoses)('%s', (_, file, messages, x) => {
    const { value, diagnostics } = read(file);
    expect(shown(diagnostics)).toEqual(messages);
    expect(value ? valuesOf(value, 'センター')[0] : null).toBe(x);
  });
});
