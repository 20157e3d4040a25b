/** The size of the plot's picture; its width fits the inspector. */
export const plotSize = { width: 300, height: 168 };
/** Where the axes are in it. */
const area = { left: 50, right: 288, top: 10, bottom: 134 };
/** The least residual that is drawn, as a part of the chain's length; lesser ones stand on it. */
const least = 1e-5;
/** The numbers of steps that are written under the plot, as far as they fit. */
const niceSteps = [0, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000];
/** The parts of the chain's length that are written beside it. */
const niceParts = [1, 0.1, 0.01, 0.001, 1e-4, 1e-5];
/** Texts under the plot are at least so far apart. */
const leastGap = 22;

/** Where values stand in the plot of residuals by steps. Both of its scales are logarithmic. */
export interface Plot {
  readonly area: typeof area;
  readonly across: (step: number) => number;
  readonly down: (part: number) => number;
  /** The marks of the axes. */
  readonly steps: readonly number[];
  readonly parts: readonly number[];
}

/**
 * @param lastStep the number of the last step of all methods
 * @param greatest the greatest residual, as a part of the chain's length
 */
export function plotOf(lastStep: number, greatest: number): Plot {
  const top = Math.max(1, greatest);
  const [high, low] = [Math.log(top), Math.log(least)];
  const across = (step: number): number =>
    area.left + (Math.log1p(step) / Math.log1p(Math.max(1, lastStep))) * (area.right - area.left);
  const down = (part: number): number =>
    area.top +
    ((high - Math.log(Math.min(top, Math.max(least, part)))) / (high - low)) *
      (area.bottom - area.top);
  const steps: number[] = [];
  for (const step of niceSteps) {
    const last = steps.at(-1);
    const isApart = last === undefined || across(step) - across(last) >= leastGap;
    if (step <= Math.max(1, lastStep) && isApart) steps.push(step);
  }
  return { area, across, down, steps, parts: niceParts };
}
