import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Tangent } from '../../../src/core/motion/clip-parts.ts';
import {
  changed,
  exactText,
  parseAmount,
  parseChange,
  parseTangent,
  parseTime,
  tangentText,
} from '../../../src/ui/curve-editor/key-text.ts';

describe('typed values', () => {
  it('are radians or degrees of an angle, and numbers without a unit of the rest', () => {
    expect(parseAmount('0.5', 'angle')).toBe(0.5);
    expect(parseAmount('540°', 'angle')).toBeCloseTo(3 * Math.PI, 12);
    expect(parseAmount('90 deg', 'angle')).toBeCloseTo(Math.PI / 2, 12);
    expect(parseAmount('90°', 'length')).toBeNull();
    expect(parseAmount('-1.5e1', 'length')).toBe(-15);
    expect(parseAmount('', 'number')).toBeNull();
  });

  it('set, add to or multiply the values of keys', () => {
    const apply = (text: string): number | null => {
      const change = parseChange(text, 'angle');
      return change && changed(change, 2);
    };
    expect([apply('3'), apply('+= 0.5'), apply('-=1'), apply('*= 2')]).toEqual([3, 2.5, 1, 4]);
    expect([apply('-1'), apply('+=')]).toEqual([-1, null]);
    expect(apply('+= 180°')).toBeCloseTo(2 + Math.PI, 12);
  });

  it('of time are seconds, or frames after f', () => {
    expect([parseTime('0.5', 30), parseTime('0.5 s', 30), parseTime('f 12', 24)]).toEqual([
      0.5, 0.5, 0.5,
    ]);
    expect([parseTime('x', 30), parseTime('f', 30)]).toEqual([null, null]);
  });
});

describe('tangents as text', () => {
  it('are a rule, a slope, or tcb with as many of its numbers as are given', () => {
    expect(parseTangent('Flat', 'angle')).toBe('flat');
    expect(parseTangent('90°/s', 'angle')).toBeCloseTo(Math.PI / 2, 12);
    expect(parseTangent('tcb 0.5, 0 -1', 'angle')).toEqual({ tcb: [0.5, 0, -1] });
    expect(parseTangent('tcb', 'angle')).toEqual({ tcb: [0, 0, 0] });
    for (const text of ['', 'flat 2', 'steep', 'tcb x', 'tcb 1 2 3 4', '5 6']) {
      expect(parseTangent(text, 'angle')).toBeNull();
    }
  });

  it('come back as they were, numbers to a millionth', () => {
    const number = fc.integer({ min: -1e9, max: 1e9 }).map((millionths) => millionths / 1e6);
    const tangent: fc.Arbitrary<Tangent> = fc.oneof(
      fc.constantFrom('flat', 'linear', 'smooth', 'auto', 'stepped'),
      number,
      fc.tuple(number, number, number).map((tcb) => ({ tcb })),
    );
    fc.assert(
      fc.property(tangent, (each) => {
        expect(parseTangent(tangentText(each), 'angle')).toEqual(normal(each));
      }),
    );
    expect(exactText(-1e-9)).toBe('0');
  });
});

/** Without negative zeros, which are written as 0. */
function normal(tangent: Tangent): Tangent {
  return JSON.parse(JSON.stringify(tangent)) as Tangent;
}
