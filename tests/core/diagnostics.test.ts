import { describe, expect, it } from 'vitest';
import {
  type Diagnostic,
  DiagnosticLog,
  formatDiagnostic,
  hasErrors,
  printable,
} from '../../src/core/diagnostics.ts';

const details = { code: 'skel/number', expected: 'x', found: 'y', effect: 'none' } as const;
const problem: Diagnostic = { severity: 'error', file: 'a.skel', ...details };

describe('formatDiagnostic', () => {
  it.each([
    [{ line: 3, column: 7 }, 'a.skel:3:7: expected x, found "y"'],
    [{ line: 3 }, 'a.skel:3: expected x, found "y"'],
    [{}, 'a.skel: expected x, found "y"'],
    [{ offset: 283 }, 'a.skel @ byte 283 (0x11b): expected x, found "y"'],
  ])('names the place %j', (place, message) => {
    expect(formatDiagnostic({ ...problem, ...place })).toBe(message);
  });

  it('shortens a long path at its front, so that the name of the file remains', () => {
    const file = `${'folder/'.repeat(100)}a.skel`;
    const message = formatDiagnostic({ ...problem, file, line: 3 });
    expect(message).toMatch(/^….{200}:3: expected x/);
    expect(message).toContain('/folder/a.skel:3: expected');
  });

  it('shortens the found text, and makes it, the file and the expected text printable', () => {
    const message = formatDiagnostic({
      ...problem,
      file: 'a\u001b[2J.skel',
      expected: 'three numbers for "\u202egnp"',
      found: 'z'.repeat(50),
    });
    expect(message).toBe(
      `a\uFFFD[2J.skel: expected three numbers for "\uFFFDgnp", found "${'z'.repeat(40)}…"`,
    );
  });
});

describe('printable', () => {
  it.each([
    ['control characters', 'a\u0000b\u001b[31m\u007f', 'a\uFFFDb\uFFFD[31m\uFFFD'],
    ['line ends', 'x\r\ny', 'x\uFFFD\uFFFDy'],
    ['bidi overrides', '\u202eevil\u202c\u2066\u200f', '\uFFFDevil\uFFFD\uFFFD\uFFFD'],
    ['line separators', 'a\u2028b\u2029', 'a\uFFFDb\uFFFD'],
    ['words of any script', 'Müller 骨 🦴 <b>', 'Müller 骨 🦴 <b>'],
  ])('shows %s without acting on the page or terminal', (_, text, shown) => {
    expect(printable(text)).toBe(shown);
  });

  it('cuts between characters, not within one', () => {
    expect(printable('🦴🦴🦴', 2)).toBe('🦴🦴…');
    expect(printable('ab', 2)).toBe('ab');
  });
});

describe('DiagnosticLog', () => {
  it('lists a hundred and counts the rest', () => {
    const log = new DiagnosticLog('a.skel');
    for (let i = 0; i < 100; i++) log.warn(details);
    expect(log.diagnostics).toHaveLength(100);
    log.warn(details);
    log.warn(details);
    expect(log.diagnostics).toHaveLength(101);
    expect(log.diagnostics.at(-1)).toMatchObject({
      severity: 'warning',
      code: 'file/more',
      found: '2 more',
    });
  });

  it('lists an error instead of a warning when there are too many', () => {
    const log = new DiagnosticLog('a.skel');
    for (let i = 0; i < 101; i++) log.warn(details);
    log.error({ ...details, found: 'the error' });
    expect(log.failed).toBe(true);
    expect(log.diagnostics).toHaveLength(101);
    expect(log.diagnostics[99]).toMatchObject({ severity: 'error', found: 'the error' });
    expect(log.diagnostics.at(-1)).toMatchObject({ severity: 'error', found: '2 more' });
    expect(log.finish('value')).not.toHaveProperty('value');
  });

  it('remembers an error that it does not list', () => {
    const log = new DiagnosticLog('a.skel');
    for (let i = 0; i < 102; i++) log.error(details);
    expect(log.diagnostics).toHaveLength(101);
    expect(log.diagnostics.at(-1)).toMatchObject({ severity: 'error', found: '2 more' });
    expect(hasErrors(log.diagnostics)).toBe(true);
  });

  it('gives the value along with warnings, and nothing along with an error', () => {
    const log = new DiagnosticLog('a.skel');
    log.warn(details);
    expect(log.finish('value')).toMatchObject({
      value: 'value',
      diagnostics: [{ file: 'a.skel' }],
    });
    log.error(details);
    expect(log.finish('value')).not.toHaveProperty('value');
  });
});
