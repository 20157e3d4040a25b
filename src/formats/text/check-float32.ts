import type { DiagnosticCode, DiagnosticLog } from '../../core/diagnostics.ts';
import type { LineReader } from './line-reader.ts';

const largest = 3.4028234663852886e38;

/**
 * The current token as a number within float32, or NaN and a diagnostic. `what` is the field's name.
 */
export function checkFloat32(
  reader: LineReader,
  what: string,
  area: 'skel' | 'obj' | 'attach',
  effect: string,
  log: DiagnosticLog,
): number {
  const value = reader.number();
  if (Math.abs(value) <= largest) return value;
  const isNumber = !Number.isNaN(value);
  const code: DiagnosticCode = `${area}/${isNumber ? 'range' : 'number'}`;
  const found = reader.text();
  const hint = /^[+-]?\d+,\d+$/.test(found) ? ' with a decimal point' : '';
  const expected = isNumber ? `${what} within ±3.4e38` : `a number for ${what}${hint}`;
  log.error({ code, ...reader.place, expected, found, effect });
  return NaN;
}
