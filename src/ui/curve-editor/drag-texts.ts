import { formatDegrees } from '../angle-text.ts';
import { exactText } from './key-text.ts';
import type { ValueUnit } from './value-axis.ts';

/** "1 key", "3 keys". */
export function keyCount(count: number): string {
  return count === 1 ? '1 key' : `${count} keys`;
}

/** "0.40 s". */
export function secondsText(time: number): string {
  return `${time.toFixed(2)} s`;
}

function signed(text: string): string {
  return text.startsWith('-') ? text : `+${text}`;
}

/** What a drag of keys does: "+0.20 s (+6 frames), +12.5°". */
export function movedText(
  seconds: number,
  fps: number,
  value: number | null,
  unit: ValueUnit,
): string {
  const frames = Number((seconds * fps).toFixed(1));
  const time = `${signed(seconds.toFixed(2))} s (${signed(String(frames))} frames)`;
  return value === null ? time : `${time}, ${signed(amountText(value, unit))}`;
}

/** "12.5°" of an angle, or a number with three digits after the point. */
function amountText(value: number, unit: ValueUnit): string {
  return unit === 'angle' ? formatDegrees(value) : exactText(Number(value.toFixed(3)));
}

/** "12.5°/s". */
export function slopeText(slope: number, unit: ValueUnit): string {
  return `${amountText(slope, unit)}/s`;
}
