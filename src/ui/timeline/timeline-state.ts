import { type Signal, signal } from '@preact/signals-core';
import type { KeyClipboard } from '../../core/motion/edit/copy-keys.ts';
import { keepValue, keptValue } from '../kept.ts';

/** How times are written: in seconds, or as numbers of frames. */
export type TimeUnit = 'seconds' | 'frames';

const isTimeUnit = (text: string): text is TimeUnit => text === 'seconds' || text === 'frames';

const keptUnit = keptValue('time unit');

/** How the timeline writes times; kept for the next visit. */
export const timeUnit: Signal<TimeUnit> = signal(isTimeUnit(keptUnit) ? keptUnit : 'seconds');

export function setTimeUnit(unit: TimeUnit): void {
  timeUnit.value = unit;
  keepValue('time unit', unit);
}

/** Whether the timeline has a row for every joint, or only for those that the clip moves. */
export const showsAllJoints = signal(false);

/** The keys that were copied last, of any character, or null. */
export const copiedKeys = signal<KeyClipboard | null>(null);

/** A time as the timeline writes it: "0.50 s", or "15" as a frame. */
export function timeText(time: number, fps: number, unit: TimeUnit): string {
  if (unit === 'seconds') return `${time.toFixed(2)} s`;
  const frame = time * fps;
  return Math.abs(frame - Math.round(frame)) < 0.005 ? String(Math.round(frame)) : frame.toFixed(1);
}
