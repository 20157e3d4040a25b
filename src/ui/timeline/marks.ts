import { markStep, type TimeWindow, xOfTime } from './time-axis.ts';
import type { TimeUnit } from './timeline-state.ts';

/** A mark of the ruler. */
export interface RulerMark {
  /** In CSS pixels from the left edge. */
  readonly x: number;
  /** Empty for a mark between two labels. */
  readonly text: string;
}

/** Room for a label, and for a mark without one, in CSS pixels. */
const [labelPixels, markPixels] = [56, 9];

/** The marks of the ruler: labels at frames or round seconds, and as many marks between as fit. */
export function rulerMarks(
  shown: TimeWindow,
  width: number,
  fps: number,
  unit: TimeUnit,
): readonly RulerMark[] {
  if (width <= 0) return [];
  const labelStep = markStep(shown, width, fps, labelPixels);
  const step = finerStep(labelStep, markStep(shown, width, fps, markPixels));
  const first = Math.ceil(shown[0] / step - 1e-9);
  const count = Math.floor(shown[1] / step + 1e-9) - first + 1;
  return Array.from({ length: Math.max(0, count) }, (_, i) => {
    const time = (first + i) * step;
    const isLabeled = isMultiple(time, labelStep);
    const text = isLabeled ? labelText(time, labelStep, fps, unit) : '';
    return { x: xOfTime(shown, width, time), text };
  });
}

/** The finest step of which the labels' step is a multiple. */
function finerStep(labelStep: number, step: number): number {
  return isMultiple(labelStep, step) ? step : labelStep;
}

function isMultiple(value: number, step: number): boolean {
  return Math.abs(value / step - Math.round(value / step)) < 1e-6;
}

function labelText(time: number, step: number, fps: number, unit: TimeUnit): string {
  // A time of −0 would be written with its sign.
  if (unit === 'frames') return String(Math.round(time * fps) + 0);
  const digits = isMultiple(step, 1)
    ? 0
    : isMultiple(step, 0.1)
      ? 1
      : isMultiple(step, 0.01)
        ? 2
        : 3;
  return (time + 0).toFixed(digits).replace(/^-(0(\.0*)?)$/, '$1');
}
