import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { formatDiagnostic, hasErrors, type Parsed } from '../../../src/core/diagnostics.ts';
import { readAnim } from '../../../src/formats/cse169/anim.ts';
import { readMorph } from '../../../src/formats/cse169/morph.ts';
import { readRig } from '../../../src/formats/cse169/rig.ts';
import { readSkel } from '../../../src/formats/cse169/skel.ts';
import { readSkin } from '../../../src/formats/cse169/skin.ts';
import { legAnim, legMorph, legRig, legSkel, legSkin } from '../../support/cse169-files.ts';
import { bytesOf } from '../../support/files.ts';

type Read = (file: string, bytes: Uint8Array) => Parsed<unknown>;

const readers: readonly (readonly [string, Read, string])[] = [
  ['.skel', readSkel, legSkel],
  ['.skin', readSkin, legSkin],
  ['.morph', readMorph, legMorph],
  ['.anim', readAnim, legAnim],
  ['.rig', readRig, legRig],
];

/** Reading gives a value or an error, never an exception, and no NaN in a value. */
function expectOutcome({ value, diagnostics }: Parsed<unknown>): void {
  expect(value === undefined).toBe(hasErrors(diagnostics));
  expect(diagnostics.length).toBeLessThanOrEqual(101);
  for (const diagnostic of diagnostics) expect(formatDiagnostic(diagnostic)).toContain('expected');
  expectFinite(value);
}

function expectFinite(value: unknown): void {
  if (typeof value === 'number') {
    if (!Number.isFinite(value)) expect.fail(`a number that is none: ${value}`);
  } else if (ArrayBuffer.isView(value)) {
    expect(Array.from(value as Float32Array).every(Number.isFinite)).toBe(true);
  } else if (typeof value === 'object' && value !== null) {
    Object.values(value).forEach(expectFinite);
  }
}

describe.each(readers)('the reader of %s', (ending, read, text) => {
  const good = bytesOf(text);

  it('handles a valid file cut at any byte', () => {
    for (let end = 0; end < good.length; end++) {
      expectOutcome(read(`a${ending}`, good.subarray(0, end)));
    }
  });

  it('handles 600 files with bytes changed, removed, inserted or moved', () => {
    const word = fc.constantFrom(
      ...'{ } -1 1e39 1e400 nan 4294967295 0 2 /* */ // # \r'.split(' '),
    );
    const edit = fc.record({
      at: fc.nat(good.length),
      removed: fc.nat(6),
      put: fc.oneof(
        fc.uint8Array({ maxLength: 3 }),
        word.map((token) => bytesOf(` ${token} `)),
      ),
    });
    fc.assert(
      fc.property(fc.array(edit, { minLength: 1, maxLength: 6 }), (edits) => {
        let bytes = [...good];
        for (const { at, removed, put } of edits) {
          bytes = [...bytes.slice(0, at), ...put, ...bytes.slice(at + removed)];
        }
        expectOutcome(read(`a${ending}`, Uint8Array.from(bytes)));
      }),
      { numRuns: 600 },
    );
  });
});
