import type { DiagnosticLog, Place } from '../../core/diagnostics.ts';
import { decodeText, firstInvalidByte } from './decode-text.ts';

/**
 * Warns if a line is not UTF-8, or has a character next to a number that only looks like a blank or
 * a minus sign; returns whether it did. It is not an error, because old tools write comments and
 * names in other encodings, and the numbers are ASCII in all of them.
 */
export function reportEncoding(log: DiagnosticLog, place: Place, line: Uint8Array): boolean {
  const invalid = firstInvalidByte(line);
  if (invalid === -1) return reportLookalike(log, place, decodeText(line));
  log.warn({
    code: 'file/encoding',
    ...place,
    column: invalid + 1,
    expected: 'UTF-8 text',
    found: `byte 0x${line[invalid]!.toString(16).toUpperCase()}`,
    effect: 'such characters are shown as \uFFFD; all else is read',
  });
  return true;
}

/**
 * Typographic spaces next to a number or to the first word of a line, and dashes before a number,
 * outside comments.
 */
const lookalike =
  /(?:[\d.]|^[ \t]*[a-z]*)([\u00a0\u2000-\u200b\u202f\u205f\u3000])|([\u2010-\u2015\u2212\ufe63\uff0d])[\d.]/i;

function reportLookalike(log: DiagnosticLog, place: Place, line: string): boolean {
  const match = lookalike.exec(line.replace(/#.*/, ''));
  if (!match) return false;
  const [text, space, dash] = match;
  const character = space ?? dash!;
  const before = line.slice(0, match.index + text.indexOf(character));
  const code = character.codePointAt(0)!.toString(16).toUpperCase().padStart(4, '0');
  log.warn({
    code: 'file/character',
    ...place,
    column: new TextEncoder().encode(before).length + 1,
    expected: space === undefined ? 'a minus sign "-"' : 'a plain space',
    found: `U+${code}, which only looks like one`,
    effect: 'what is beside such characters can not be read; replace all of them',
  });
  return true;
}

export function reportLength(log: DiagnosticLog, place: Place, found: number, most: number): void {
  log.error({
    code: 'file/limit',
    ...place,
    expected: `a line of at most ${most} bytes`,
    found: `${found}`,
    effect: 'the file is not used',
  });
}

/** Reports that the last line ends in a continuation. */
export function reportOpenEnd(log: DiagnosticLog, place: Place): void {
  log.warn({
    code: 'file/continuation',
    ...place,
    expected: 'a line after one that ends in \\',
    found: 'the end of the file',
    effect: 'the line is read as it stands',
  });
}
