/** The size of the plot's picture; its width fits the inspector. */
export const plotSize = { width: 300, height: 164 };
/** Where the axes are in it. */
const area = { left: 44, right: 292, top: 26, bottom: 130 };
/** The distances of marks, of which the first that leaves few is taken: per cent and degrees. */
const percentSteps = [1, 2, 5, 10, 20, 50, 100, 200, 500];
const degreeSteps = [5, 10, 15, 30, 45, 90, 180, 360];
const [mostAcross, mostDown] = [6, 5];
/** Values are drawn on a scale of at least so many per cent. */
const leastRange = 4;
/** Values above so many per cent, which a mesh that turns inside out may have, are cut off. */
const mostPercent = 400;

/** Where angles and per cents stand in the plot of a sweep. */
interface SweepPlot {
  readonly area: typeof area;
  /** The place of an angle in degrees. */
  readonly across: (degrees: number) => number;
  /** The place of a part of what is at rest, in per cent. */
  readonly down: (percent: number) => number;
  /** The marks of the axes. */
  readonly angles: readonly number[];
  readonly percents: readonly number[];
}

/**
 * @param range the angles at the left and at the right edge, in degrees
 * @param values in per cent
 */
export function plotOf(range: readonly [number, number], values: readonly number[]): SweepPlot {
  const [start, end] = range;
  const high = Math.min(
    mostPercent,
    values.reduce((most, value) => Math.max(most, value), 100),
  );
  const low = values.reduce((least, value) => Math.min(least, value), 100);
  const missing = Math.max(0, leastRange - (high - low)) / 2;
  const [top, bottom] = [high + missing, low - missing];
  const across = (degrees: number): number =>
    area.left + ((degrees - start) / (end - start)) * (area.right - area.left);
  const down = (percent: number): number => {
    const part = (Math.min(top, Math.max(bottom, percent)) - bottom) / (top - bottom);
    return area.bottom - part * (area.bottom - area.top);
  };
  return {
    area,
    across,
    down,
    angles: marksWithin(start, end, degreeSteps, mostAcross),
    percents: marksWithin(bottom, top, percentSteps, mostDown),
  };
}

function marksWithin(low: number, high: number, steps: readonly number[], most: number): number[] {
  const step = steps.find((each) => (high - low) / each <= most) ?? steps.at(-1)!;
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: count }, (_, i) => (first + i) * step);
}

/** The points of a line as SVG has them; where a value is missing the line ends. */
export function linesOf(
  { across, down }: SweepPlot,
  degrees: readonly number[],
  percents: readonly (number | null)[],
): readonly string[] {
  const lines: string[][] = [[]];
  percents.forEach((percent, i) => {
    if (percent === null) lines.push([]);
    else lines.at(-1)!.push(`${across(degrees[i]!).toFixed(2)},${down(percent).toFixed(2)}`);
  });
  return lines.filter((line) => line.length > 0).map((line) => line.join(' '));
}
