import { describe, expect, it } from 'vitest';
import { morphOffsets, readMorph } from '../../../src/formats/cse169/morph.ts';
import { readRig } from '../../../src/formats/cse169/rig.ts';
import { legMorph, legRig } from '../../support/cse169-files.ts';
import { shown } from '../../support/diagnose.ts';
import { bytesOf } from '../../support/files.ts';

describe('readRig', () => {
  const read = (text: string) => readRig('a.rig', bytesOf(text));

  it('reads the names of the files', () => {
    expect(read(legRig)).toEqual({
      value: { name: 'leg', skeleton: 'leg.skel', skin: 'leg.skin', morphs: ['bent.morph'] },
      diagnostics: [],
    });
    expect(read('rig{skin a.skin}').value).toEqual({ name: '', skin: 'a.skin', morphs: [] });
  });

  it('reads names in quotation marks, with blanks and braces', () => {
    const text =
      'rig "a leg" { skeleton "my {leg}.skel" skin "leg.skin" morphs 2 { "b c.morph" d } }';
    expect(read(text)).toEqual({
      value: {
        name: 'a leg',
        skeleton: 'my {leg}.skel',
        skin: 'leg.skin',
        morphs: ['b c.morph', 'd'],
      },
      diagnostics: [],
    });
    expect(read('rig a { skin "b\n}').value).toEqual({ name: 'a', skin: '"b', morphs: [] });
  });

  it.each([
    ['skin a', '1:1: expected "rig", found "skin" [rig/token]'],
    ['rig a { skin', '1:13: expected a file, found "the end of the file" [rig/end]'],
    ['rig a { morphs 2 { b } }', '1:22: expected a file, found "}" [rig/token]'],
    ['rig a { morphs 1 { b c } }', '1:22: expected "}" for the morphs, found "c" [rig/token]'],
  ])('refuses %j', (text, message) => {
    expect(shown(read(text).diagnostics)).toEqual([
      `error: a.rig:${message}; the files are grouped by their names`,
    ]);
  });
});

describe('readMorph', () => {
  const read = (text: string) => readMorph('a.morph', bytesOf(text));

  it('holds targets that hide a part by lying past all numbers', () => {
    const { value, diagnostics } = read('positions 1 { 0 1e30 -1e400 0.5 }');
    expect(diagnostics).toEqual([]);
    expect([...value!.positions.values]).toEqual([1e18, -1e18, 0.5]);
  });

  it('reads absolute targets, which become offsets from the skin', () => {
    const file = read(legMorph).value!;
    expect([...file.positions.points]).toEqual([2, 3]);
    expect([...file.positions.values]).toEqual([0, 0.5, 0.4, 0, 0, 0.6]);
    const base = Float32Array.from({ length: 12 }, (_, i) => i / 8);
    const { value } = morphOffsets(file, base, base);
    expect(value).toMatchObject({ name: 'a', file: 'a.morph' });
    expect(value!.offsets[1]).toBe(Math.fround(0.5 - 7 / 8));
    expect([...value!.normalPoints]).toEqual([2]);
  });

  it('accepts a single section, and uses the last of two rows for a vertex', () => {
    const { value, diagnostics } = read('positions 2 { 0 1 2 3 0 4 5 6 }');
    expect([...value!.positions.values]).toEqual([4, 5, 6]);
    expect(value!.normals.points).toHaveLength(0);
    expect(diagnostics).toMatchObject([{ code: 'morph/duplicate' }]);
  });

  it.each([
    ['# none', ': expected "positions", found "none" [morph/section]'],
    ['positions 1 { 0 1 2 }', ':1:21: expected a number for positions z, found "}" [morph/number]'],
    [
      'positions 1 { -1 1 2 3 }',
      ':1:15: expected a whole number for a vertex, 0 or more, found "-1" [morph/integer]',
    ],
    [
      'positions 2 { 0 1 2 3 } # and no more',
      ':1:23: expected 2 rows of positions, as the file says, found "1" [morph/count]',
    ],
    [
      'positions 0 { } positions 0 { }',
      ':1:17: expected one section "positions", found "another" [morph/duplicate]',
    ],
  ])('refuses %j', (text, message) => {
    const [first] = shown(read(text).diagnostics);
    expect(first!.replace(/a\.morph:1:7/, 'a.morph')).toBe(
      `error: a.morph${message}; the morph is not used`,
    );
  });
});
