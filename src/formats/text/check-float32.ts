import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { LineReader } from './line-reader.ts';
import { boundText } from './bound-text.ts';

export const largestFloat32 = 3.4028234663852886e38;

/** The name and bounds of a number, for messages. */
export interface NumberField {
  /** The field's name. */
  readonly what: string;
  readonly area: 'skel' | 'obj' | 'attach';
  readonly effect: string;
  /** The largest magnitude, if it is less than that of a float32. */
  readonly largest?: number | undefined;
}

/** Returns the current token as a number within its bounds, or NaN with a diagnostic. */
export function checkFloat32(
  reader: LineReader,
  { what, area, effect, largest = largestFloat32 }: NumberField,
  log: DiagnosticLog,
): number {
  const value = reader.number();
  if (Math.abs(value) <= largest) return value;
  const found = reader.text();
  if (reader.isTooLong) {
    fail('limit', `a number of at most ${reader.limits.tokenLength} characters for ${what}`);
  } else if (Number.isNaN(value)) {
    const hint = /^[+-]?\d+,\d+$/.test(found) ? ' with a decimal point' : '';
    fail('number', `a number for ${what}${hint}`);
  } else fail('range', `${what} within ±${boundText(largest)}`);
  return NaN;

  function fail(kind: 'limit' | 'number' | 'range', expected: string): void {
    log.error({ code: `${area}/${kind}`, ...reader.place, expected, found, effect });
  }
}
