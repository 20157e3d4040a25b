import { expect } from 'vitest';
import { formatDiagnostic, hasErrors } from '../../src/core/diagnostics.ts';
import { expectPosable, expectSound } from '../support/check-character.ts';
import type { FileContents } from '../support/files.ts';
import { readSoon } from '../support/read-soon.ts';

/**
 * Expects that reading neither throws nor hangs, and returns valid characters or reports why not.
 */
export async function expectOutcome(contents: FileContents): Promise<void> {
  const { characters, diagnostics } = await readSoon(contents);
  for (const { character } of characters) {
    expectSound(character);
    if (character.mesh.pointCount > 0 && !hasErrors(diagnostics)) expectPosable(character);
  }
  for (const diagnostic of diagnostics) {
    const message = formatDiagnostic(diagnostic);
    expect(message).toMatch(
      /^[^\p{Cc}\p{Cf}]+: expected [^\p{Cc}\p{Cf}]+, found "[^\p{Cc}\p{Cf}]*"$/u,
    );
    expect(message.length).toBeLessThan(600);
  }
  if (characters.length === 0) expect(diagnostics.length).toBeGreaterThan(0);
}
