import { type TimeWindow, xOfTime } from './time-axis.ts';
import type { TimeUnit } from './timeline-state.ts';

/** A mark of the ruler. */
export interface RulerMark {
  /** In CSS pixels from the left edge. */
  readonly x: number;
  /** Empty for a mark between two labels. */
  readonly text: string;
}

/** Room for a label, and for a mark without one, in CSS pixels. */
const [labelPixels, markPixels] = [56, 7];

/** The marks of the ruler: labels at frames or round seconds, and as many marks between as fit. */
export function rulerMarks(
  shown: TimeWindow,
  width: number,
  fps: number,
  unit: TimeUnit,
): readonly RulerMark[] {
  if (width <= 0) return [];
  const perPixel = (shown[1] - shown[0]) / width;
  // Frames are whole; seconds are not.
  const [base, least] = unit === 'frames' ? [1 / fps, 1 / fps] : [1, 0];
  const labelStep = roundStep(labelPixels * perPixel, base, least);
  const finer = roundStep(markPixels * perPixel, base, least);
  const step = isMultiple(labelStep, finer) ? finer : labelStep;
  const first = Math.ceil(shown[0] / step - 1e-9);
  const count = Math.floor(shown[1] / step + 1e-9) - first + 1;
  const digits = Math.max(0, Math.ceil(-Math.log10(labelStep) - 1e-9));
  return Array.from({ length: Math.max(0, count) }, (_, i) => {
    const time = (first + i) * step;
    const number = unit === 'frames' ? String(Math.round(time * fps)) : time.toFixed(digits);
    // A time a little below 0 would be written as −0.
    const text = isMultiple(time, labelStep) ? number.replace(/^-(0(\.0*)?)$/, '$1') : '';
    return { x: xOfTime(shown, width, time), text };
  });
}

/** The least 1, 2 or 5 times a power of ten of a base, at least as long as two steps, in seconds. */
function roundStep(atLeast: number, base: number, least: number): number {
  const wanted = Math.max(atLeast, least) / base;
  const power = 10 ** Math.floor(Math.log10(wanted) + 1e-9);
  const factor = [1, 2, 5, 10].find((each) => each * power >= wanted * (1 - 1e-9))!;
  return factor * power * base;
}

function isMultiple(value: number, step: number): boolean {
  return Math.abs(value / step - Math.round(value / step)) < 1e-6;
}
