import { expect } from 'vitest';
import { formatDiagnostic, hasErrors } from '../../src/core/diagnostics.ts';
import { expectPosable, expectSound } from '../support/check-character.ts';
import { type FileContents, readContents } from '../support/files.ts';

/** A guard against hanging: what is read here is small. */
const longestRead = 1000;

/** Reads without throwing and soon, and gives sound characters or says why not. */
export async function expectOutcome(contents: FileContents): Promise<void> {
  const before = performance.now();
  const { characters, diagnostics } = await readContents(contents);
  expect(performance.now() - before).toBeLessThan(longestRead);
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
