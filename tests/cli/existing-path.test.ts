import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, it, onTestFinished } from 'vitest';
import { existingPath } from '../../src/cli/existing-path.ts';

it('finds composed names by decomposed ones and the other way round, also of folders', () => {
  const folder = mkdtempSync(join(tmpdir(), 'sinew-'));
  onTestFinished(() => rmSync(folder, { recursive: true }));
  const [composed, decomposed] = ['ガ'.normalize('NFC'), 'ガ'.normalize('NFD')];
  mkdirSync(join(folder, decomposed));
  writeFileSync(join(folder, decomposed, `${composed}.pmd`), '');
  const there = join(folder, decomposed, `${composed}.pmd`);
  for (const [first, second] of [
    [composed, composed],
    [composed, decomposed],
    [decomposed, decomposed],
  ]) {
    expect(existingPath(join(folder, first!, `${second!}.pmd`))).toBe(there);
  }
  const absent = join(folder, 'x', 'y.pmd');
  expect(existingPath(absent)).toBe(absent);
});
