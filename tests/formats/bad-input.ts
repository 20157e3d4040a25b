import { afterAll, afterEach, beforeAll, describe, expect, it, vi } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import type { Diagnostic } from '../../src/core/diagnostics.ts';
import type { Limits } from '../../src/core/limits.ts';
import { noJoint } from '../../src/core/skin.ts';
import { expectSound } from '../support/check-character.ts';
import type { FileContents } from '../support/files.ts';
import { readSoon } from '../support/read-soon.ts';

/**
 * A row of a table of bad files: the files, the expected messages, and what remains of the
 * character.
 */
export interface BadInput {
  /** The number and the description of the case: "A13 parent past the end". */
  readonly title: string;
  readonly files: FileContents;
  /** Smaller limits than Sinew's own, for cases that would otherwise be large. */
  readonly limits?: Partial<Limits>;
  /** Every message, `severity: FILE:LINE:COL: expected …, found "…" [code]`. */
  readonly messages: readonly string[];
  readonly left: Left | null;
  readonly check?: (character: Character) => void;
}

/** The parts of a character that can be shown. */
export interface Left {
  readonly joints: number;
  readonly vertices: number;
  readonly triangles: number;
  /** Whether the mesh follows the joints. */
  readonly bound: boolean;
}

/** A table of bad files, whose kinds are numbered from 1 after a letter. */
export interface BadInputTable {
  readonly letter: string;
  readonly kinds: number;
  readonly cases: readonly BadInput[];
  /** How the messages are written in the table. */
  readonly say: (diagnostics: readonly Diagnostic[]) => string[];
}

function leftOf({ skeleton, mesh, skin }: Character): Left {
  return {
    joints: skeleton.jointCount,
    vertices: mesh.pointCount,
    triangles: mesh.indices.length / 3,
    bound: mesh.pointCount > 0 && !skin.paletteJoint.includes(noJoint),
  };
}

/** Tests that a table has all its kinds, and tests each of its cases. No case fetches anything. */
export function testBadInputs(label: string, { letter, kinds, cases, say }: BadInputTable): void {
  const numberOf = ({ title }: BadInput): number =>
    Number(new RegExp(`^${letter}(\\d+) `).exec(title)?.[1]);

  describe(label, () => {
    const fetched = vi.fn();
    beforeAll(() => {
      vi.stubGlobal('fetch', fetched);
    });
    afterEach(() => expect(fetched).not.toHaveBeenCalled());
    afterAll(() => {
      vi.unstubAllGlobals();
    });

    it(`come in all ${kinds} kinds, each case under a name of its own`, () => {
      const numbers = Array.from({ length: kinds }, (_, index) => index + 1);
      const found = new Set(cases.map(numberOf));
      expect([...found].toSorted((a, b) => a - b)).toEqual(numbers);
      expect(new Set(cases.map(({ title }) => title)).size).toBe(cases.length);
    });

    const inOrder = cases.toSorted((a, b) => numberOf(a) - numberOf(b));
    it.each(inOrder)('$title', async ({ files, limits, messages, left, check }) => {
      const { characters, diagnostics } = await readSoon(files, limits);
      expect(say(diagnostics)).toEqual(messages);
      expect(characters.map(({ character }) => leftOf(character))).toEqual(left ? [left] : []);
      for (const { effect } of diagnostics) expect(effect).not.toBe('');
      for (const { character } of characters) {
        expectSound(character);
        check?.(character);
      }
    });
  });
}
