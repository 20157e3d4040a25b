import type { Plot, ValueWindow } from './plot.ts';

/** What a value is measured in: an angle in radians, a length in the model's units, or a bare number. */
export type ValueUnit = 'angle' | 'length' | 'number';

/** A line of the plot's grid. */
interface ValueMark {
  readonly plotted: number;
  readonly text: string;
}

const degree = Math.PI / 180;
const degreeSteps = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 45, 90, 180, 360];

/** The round values that are marked, at least so many pixels apart; angles in degrees, never wrapped. */
export function valueMarks(
  { values, height }: Pick<Plot, 'values' | 'height'>,
  unit: ValueUnit,
  leastPixels = 26,
): readonly ValueMark[] {
  const least = ((values[1] - values[0]) * leastPixels) / height;
  const step = unit === 'angle' ? angleStep(least) : roundStep(least);
  return multiples(values, step).map((count) => {
    const plotted = count * step;
    return { plotted, text: markText(plotted, step, unit) };
  });
}

function multiples([low, high]: ValueWindow, step: number): number[] {
  const first = Math.ceil(low / step);
  const count = Math.floor(high / step) - first + 1;
  return Array.from({ length: Math.max(0, count) }, (_, i) => first + i);
}

function angleStep(least: number): number {
  const found = degreeSteps.find((degrees) => degrees * degree >= least);
  if (found !== undefined && found * degree <= Math.max(least, 0.1 * degree) * 10) {
    return found * degree;
  }
  return roundStep(least / degree) * degree;
}

/** The least of 1, 2 and 5 times a power of ten that is not below a number. */
function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return ([1, 2, 5, 10].find((each) => each * power >= least * (1 - 1e-9)) ?? 10) * power;
}

function markText(plotted: number, step: number, unit: ValueUnit): string {
  const [value, size] = unit === 'angle' ? [plotted / degree, step / degree] : [plotted, step];
  const decimals = Math.min(Math.max(0, -Math.floor(Math.log10(size) + 1e-9)), 8);
  const text = value.toFixed(decimals).replace(/^-(?=0(\.0*)?$)/, '');
  return unit === 'angle' ? `${text}°` : text;
}
