import { afterAll, afterEach, beforeAll, describe, expect, it, vi } from 'vitest';
import type { Character } from '../../../../src/core/character.ts';
import { noJoint } from '../../../../src/core/skin.ts';
import { expectSound } from '../../../support/check-character.ts';
import { said } from '../../../support/diagnose.ts';
import { readSoon } from '../../../support/read-soon.ts';
import { attachCases } from './attach-cases.ts';
import type { BadInput, Left } from './bad-input.ts';
import { objFaces } from './obj-faces.ts';
import { objLines } from './obj-lines.ts';
import { setCases } from './set-cases.ts';
import { skelNumbers } from './skel-numbers.ts';
import { skelTrees } from './skel-trees.ts';
import { textCases } from './text-cases.ts';

const cases: readonly BadInput[] = [
  ...[...skelNumbers, ...skelTrees, ...textCases],
  ...[...objLines, ...objFaces, ...attachCases, ...setCases],
].toSorted((a, b) => numberOf(a) - numberOf(b));

function numberOf({ title }: BadInput): number {
  return Number(/^A(\d+) /.exec(title)?.[1]);
}

function leftOf({ skeleton, mesh, skin }: Character): Left {
  return {
    joints: skeleton.jointCount,
    vertices: mesh.pointCount,
    triangles: mesh.indices.length / 3,
    bound: mesh.pointCount > 0 && !skin.paletteJoint.includes(noJoint),
  };
}

describe('bad files of 6.837', () => {
  const fetched = vi.fn();
  beforeAll(() => {
    vi.stubGlobal('fetch', fetched);
  });
  afterEach(() => expect(fetched).not.toHaveBeenCalled());
  afterAll(() => {
    vi.unstubAllGlobals();
  });

  it('come in all 68 kinds, each case under a name of its own', () => {
    const numbers = Array.from({ length: 68 }, (_, index) => index + 1);
    expect([...new Set(cases.map(numberOf))]).toEqual(numbers);
    expect(new Set(cases.map(({ title }) => title)).size).toBe(cases.length);
  });

  it.each(cases)('$title', async ({ files, limits, messages, left, check }) => {
    const { characters, diagnostics } = await readSoon(files, limits);
    expect(said(diagnostics)).toEqual(messages);
    expect(characters.map(({ character }) => leftOf(character))).toEqual(left ? [left] : []);
    for (const { effect } of diagnostics) expect(effect).not.toBe('');
    for (const { character } of characters) {
      expectSound(character);
      check?.(character);
    }
  });
});
