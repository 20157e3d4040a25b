import { describe, expect, it } from 'vitest';
import { MatrixStack } from '../../src/core/matrix-stack.ts';
import { identity, multiply, rotationAbout, translation } from '../reference/matrix.ts';
import { columnMajor, largestDifference } from '../support/compare.ts';
import { tolerances } from '../tolerances.ts';

const outer = multiply(translation([1, 2, 3]), rotationAbout([0, 0, 1], 0.7));
const inner = multiply(translation([-4, 0, 1]), rotationAbout([1, 0, 0], -0.3));

describe('MatrixStack', () => {
  it('is the identity while empty', () => {
    expect([...new MatrixStack().top]).toEqual(columnMajor(identity));
  });

  it('multiplies what is pushed by the matrix below it', () => {
    const stack = new MatrixStack();
    stack.push(columnMajor(outer));
    stack.push(columnMajor(inner));
    const expected = columnMajor(multiply(outer, inner));
    expect(largestDifference([...stack.top], expected)).toBeLessThan(tolerances.kinematics);
    expect(stack.depth).toBe(2);
  });

  it('returns to the matrix below on pop', () => {
    const stack = new MatrixStack();
    stack.push(columnMajor(outer));
    stack.push(columnMajor(inner));
    stack.pop();
    expect([...stack.top]).toEqual(columnMajor(outer));
    stack.pop();
    expect([...stack.top]).toEqual(columnMajor(identity));
  });

  it('uses its levels again without mixing them up', () => {
    const stack = new MatrixStack();
    stack.push(columnMajor(inner));
    stack.popTo(0);
    stack.push(columnMajor(outer));
    expect([...stack.top]).toEqual(columnMajor(outer));
  });

  it('throws on a pop when empty and on a depth that it does not have', () => {
    const stack = new MatrixStack();
    expect(() => stack.pop()).toThrow('empty matrix stack');
    expect(() => stack.popTo(1)).toThrow('depth');
    expect(() => stack.popTo(-1)).toThrow('depth');
  });
});
