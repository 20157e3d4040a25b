import type { Tangent } from '../../core/motion/clip-parts.ts';
import { formatDegrees, parseTyped } from '../angle-text.ts';
import type { ValueUnit } from './value-axis.ts';

/** Formats a number with as many as six digits after the point, and without zeros at its end. */
export function exactText(value: number): string {
  const rounded = Number(value.toFixed(6));
  return String(rounded === 0 ? 0 : rounded);
}

/** What stands beside a value: an angle's degrees. */
export function besideText(value: number, unit: ValueUnit): string {
  return unit === 'angle' ? formatDegrees(value) : '';
}

/** What a value is measured in, as a field names it. */
export const unitNames: Readonly<Record<ValueUnit, string>> = {
  angle: 'rad',
  length: 'units',
  number: '',
};

/** How a typed text changes values: sets them all, or adds to each, or multiplies each. */
export interface TypedChange {
  readonly of: 'set' | 'add' | 'multiply';
  readonly amount: number;
}

/**
 * Parses "0.5", "30°" (of an angle), or a change of each value: "+= 0.1", "-= 5°", "*= 2"; null if
 * it is none of these.
 */
export function parseChange(text: string, unit: ValueUnit): TypedChange | null {
  const [, sign, rest = ''] = /^\s*(?:([+\-*])=)?(.*)$/.exec(text) ?? [];
  const amount = parseAmount(rest, sign === '*' ? 'number' : unit);
  if (amount === null) return null;
  if (sign === '*') return { of: 'multiply', amount };
  if (sign === undefined) return { of: 'set', amount };
  return { of: 'add', amount: sign === '-' ? -amount : amount };
}

export function changed({ of, amount }: TypedChange, value: number): number {
  if (of === 'set') return amount;
  return of === 'add' ? value + amount : value * amount;
}

/** Parses a number; only an angle may be in degrees. Null if it is none. */
export function parseAmount(text: string, unit: ValueUnit): number | null {
  if (unit !== 'angle' && /[°a-df-z]/i.test(text)) return null;
  const amount = parseTyped(text);
  return Number.isFinite(amount) ? amount : null;
}

/** Parses seconds, or a frame after "f": "0.5", "f 12". */
export function parseTime(text: string, fps: number): number | null {
  const [, frame] = /^\s*f\s*(.+)$/i.exec(text) ?? [];
  const amount = parseAmount(frame ?? text.replace(/\s*s\s*$/i, ''), 'number');
  return amount !== null && frame !== undefined ? amount / fps : amount;
}

const tangentWords = ['flat', 'linear', 'smooth', 'auto', 'stepped'] as const;

/** Writes a tangent: its rule, a slope in value a second, or "tcb" with its three numbers. */
export function tangentText(tangent: Tangent): string {
  if (typeof tangent === 'number') return exactText(tangent);
  return typeof tangent === 'string' ? tangent : `tcb ${tangent.tcb.map(exactText).join(' ')}`;
}

/** Parses what `tangentText` writes; slopes of angles may be in degrees. Null if it is none. */
export function parseTangent(text: string, unit: ValueUnit): Tangent | null {
  const words = text
    .trim()
    .toLowerCase()
    .split(/[\s,]+/);
  const rule = tangentWords.find((each) => each === words[0]);
  if (rule !== undefined) return words.length === 1 ? rule : null;
  if (words[0] !== 'tcb') return parseAmount(text.replace(/\/\s*s\s*$/i, ''), unit);
  const numbers = words.slice(1).map((word) => parseAmount(word, 'number'));
  const [tension = 0, continuity = 0, bias = 0] = numbers;
  if (numbers.length > 3 || tension === null || continuity === null || bias === null) return null;
  return { tcb: [tension, continuity, bias] };
}
