import { afterAll, afterEach, beforeAll, describe, expect, it, vi } from 'vitest';
import type { Character } from '../../../../src/core/character.ts';
import { noJoint } from '../../../../src/core/skin.ts';
import { expectSound } from '../../../support/check-character.ts';
import { said } from '../../../support/diagnose.ts';
import { readSoon } from '../../../support/read-soon.ts';
import type { BadPmd, Left } from './bad-pmd.ts';
import { boneCases } from './bone-cases.ts';
import { extraCases } from './extra-cases.ts';
import { headerCases } from './header-cases.ts';
import { meshCases } from './mesh-cases.ts';

const cases: readonly BadPmd[] = [
  ...[...headerCases, ...meshCases, ...boneCases, ...extraCases],
].toSorted((a, b) => numberOf(a) - numberOf(b));

function numberOf({ title }: BadPmd): number {
  return Number(/^C(\d+) /.exec(title)?.[1]);
}

function leftOf({ skeleton, mesh, skin }: Character): Left {
  return {
    joints: skeleton.jointCount,
    vertices: mesh.pointCount,
    triangles: mesh.indices.length / 3,
    bound: mesh.pointCount > 0 && !skin.paletteJoint.includes(noJoint),
  };
}

describe('bad PMD files', () => {
  const fetched = vi.fn();
  beforeAll(() => {
    vi.stubGlobal('fetch', fetched);
  });
  afterEach(() => expect(fetched).not.toHaveBeenCalled());
  afterAll(() => {
    vi.unstubAllGlobals();
  });

  it('come in all 66 kinds, each case under a name of its own', () => {
    const numbers = Array.from({ length: 66 }, (_, index) => index + 1);
    expect([...new Set(cases.map(numberOf))]).toEqual(numbers);
    expect(new Set(cases.map(({ title }) => title)).size).toBe(cases.length);
  });

  it.each(cases)('$title', async ({ bytes, beside, limits, messages, left, check }) => {
    const { characters, diagnostics } = await readSoon({ 'a.pmd': bytes, ...beside }, limits);
    expect(said(diagnostics)).toEqual(messages);
    expect(characters.map(({ character }) => leftOf(character))).toEqual(left ? [left] : []);
    for (const { effect } of diagnostics) expect(effect).not.toBe('');
    for (const { character } of characters) {
      expectSound(character);
      check?.(character);
    }
  });
});
