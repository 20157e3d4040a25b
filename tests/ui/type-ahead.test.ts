import { describe, expect, it } from 'vitest';
import { TypeAhead } from '../../src/ui/type-ahead.ts';

const names = ['Root', 'Left hand', 'Left hip', 'leg_l1_tibia', 'Right hand', '左ひじ left elbow'];

/** The rows that a word finds, letter by letter, 100 ms apart. */
function typed(word: string, at = 0, find = new TypeAhead()): number[] {
  let row = at;
  return Array.from(word).map((letter, i) => {
    const found = find.find(names, row, letter, i * 100);
    if (found >= 0) row = found;
    return found;
  });
}

describe('letters in the list of joints', () => {
  it('find a row by the start of its name, and go on from it while the word fits', () => {
    expect(typed('left h')).toEqual([1, 1, 1, 1, 1, 1]);
    expect(typed('left hi').at(-1)).toBe(2);
    expect(typed('ri')).toEqual([4, 4]);
  });

  it('find any word of a name, in another script and in capitals as well', () => {
    expect(typed('tib').at(-1)).toBe(3);
    expect(typed('ELB').at(-1)).toBe(5);
    expect(typed('左').at(-1)).toBe(5);
  });

  it('go from row to row where one is repeated, and around the end', () => {
    expect(typed('hhhh', 0)).toEqual([1, 2, 4, 1]);
  });

  it('begin another word after a pause, and find nothing where nothing fits', () => {
    const find = new TypeAhead();
    expect(find.find(names, 0, 'r', 0)).toBe(4);
    expect(find.isTyping(500)).toBe(true);
    expect(find.isTyping(2000)).toBe(false);
    expect(find.find(names, 4, 't', 2000)).toBe(3);
    expect(typed('x')).toEqual([-1]);
    expect(find.find([], 0, 'a', 9000)).toBe(-1);
  });
});
