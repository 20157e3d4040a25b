import { bytesOf, displayable, type Lch, type Triple } from '../../core/oklab.ts';

/** A color for the display: sRGB bytes. */
export type Bytes = Triple;

/** The color of exactly zero: gray, so that it is not taken for the smallest value of a ramp. */
export const zeroColor: Bytes = [112, 116, 122];
/** The color of what is below zero and should not be. */
export const belowColor: Bytes = [20, 20, 24];

const stepCount = 256;

/** (256) colors between two, evenly spaced in OKLab's lightness, chroma and hue. */
function rampBetween(from: Lch, to: Lch): readonly Bytes[] {
  const between = (key: keyof Lch, part: number): number =>
    from[key] + part * (to[key] - from[key]);
  return Array.from({ length: stepCount }, (_, step) => {
    const part = step / (stepCount - 1);
    const [lightness, chroma] = [between('lightness', part), between('chroma', part)];
    return bytesOf(displayable({ lightness, chroma, hue: between('hue', part) }));
  });
}

/** @param value from 0 to 1; others count as the nearer of these */
export function colorAt(ramp: readonly Bytes[], value: number): Bytes {
  return ramp[Math.round(Math.min(1, Math.max(0, value)) * (stepCount - 1))]!;
}

/** From a pale to a dark color of one hue, for the weights of the joint that has it. */
export function hueRamp(hue: number): readonly Bytes[] {
  return rampBetween({ lightness: 0.95, chroma: 0.04, hue }, { lightness: 0.4, chroma: 0.17, hue });
}

/** From pale yellow to dark red, for errors. */
export const errorRamp = rampBetween(
  { lightness: 0.95, chroma: 0.09, hue: 105 },
  { lightness: 0.36, chroma: 0.15, hue: 20 },
);

/** For what falls short, from pale to dark blue, and for what exceeds, from pale to dark orange. */
export const shortRamp = rampBetween(
  { lightness: 0.92, chroma: 0.04, hue: 255 },
  { lightness: 0.38, chroma: 0.16, hue: 262 },
);
export const excessRamp = rampBetween(
  { lightness: 0.92, chroma: 0.06, hue: 75 },
  { lightness: 0.42, chroma: 0.13, hue: 50 },
);

/**
 * The color of each number of influences, from none to the last, which stands for it and more: one
 * to four, which every engine takes, are blue, more are orange.
 */
export const countColors: readonly Bytes[] = [
  belowColor,
  ...[0.04, 0.3, 0.55, 0.85].map((part) => colorAt(shortRamp, part)),
  ...[0.1, 0.35, 0.6, 0.8, 1].map((part) => colorAt(excessRamp, part)),
];
