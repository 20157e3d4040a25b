import { rounded, type Truncation } from '../evaluation/truncation.ts';
import {
  belowColor,
  type Bytes,
  countColors,
  errorRamp,
  excessRamp,
  hueRamp,
  shortRamp,
  zeroColor,
} from '../skinning/weights/ramps.ts';
import {
  rowCount,
  rowSum,
  type WeightSubject,
  type WeightViewId,
} from '../skinning/weights/views.ts';
import { cssColor } from './css-color.ts';

/** What the colors of a view of weights mean. */
export interface WeightLegend {
  readonly note: string;
  /** Colors that stand for one value each. */
  readonly swatches: readonly { readonly color: string; readonly text: string }[];
  /** A scale of colors as CSS writes it, with the texts at its two ends and between them. */
  readonly scale?: { readonly gradient: string; readonly texts: readonly string[] };
}

export interface LegendSubject extends WeightSubject {
  readonly jointName: string | null;
  readonly truncation: Truncation | null;
}

type Describe = (subject: LegendSubject) => WeightLegend;

/** The legend of each view. */
export const weightLegends: Readonly<Record<WeightViewId, Describe>> = {
  joints: () => ({
    note: 'Joints have their colors in the list; vertices have the mean by weight.',
    swatches: [],
  }),
  joint: ({ jointName, joint, colors, skin }) => {
    if (jointName === null || joint === null) {
      return { note: 'Select a joint, or point at one.', swatches: [] };
    }
    const isNegative = skin.weights.some((weight) => weight < 0);
    return {
      note: jointName,
      swatches: [swatch(zeroColor, 'none'), ...(isNegative ? [swatch(belowColor, 'below 0')] : [])],
      scale: { gradient: gradientOf(hueRamp(colors.hues[joint]!)), texts: ['0', '0.5', '1'] },
    };
  },
  count: ({ skin }) => {
    const counts = new Array<number>(countColors.length).fill(0);
    for (let point = 0; point + 1 < skin.start.length; point++) {
      counts[Math.min(rowCount(skin, point), counts.length - 1)]! += 1;
    }
    const swatches = counts.flatMap((count, number) => {
      const more = number === counts.length - 1 ? ' or more' : '';
      const text = `${number}${more}: ${count.toLocaleString('en')}`;
      return count > 0 ? [swatch(countColors[number]!, text)] : [];
    });
    return { note: 'Influences, and how many vertices have so many', swatches };
  },
  sum: ({ skin }) => {
    const pointCount = skin.start.length - 1;
    let off = 0;
    for (let point = 0; point < pointCount; point++) {
      if (Math.abs(rowSum(skin, point) - 1) > warned) off++;
    }
    const number = (count: number): string => count.toLocaleString('en');
    return {
      note: `Sum − 1; ${number(off)} of ${number(pointCount)} are off by over ${warned}`,
      swatches: [swatch(zeroColor, 'within 10⁻⁶')],
      scale: {
        gradient: gradientOf([...shortRamp.toReversed(), ...excessRamp]),
        texts: ['−1', '−0.001', '±10⁻⁶', '0.001', '1'],
      },
    };
  },
  error: ({ truncation }) => {
    if (!truncation) return { note: 'All influences are kept: nothing moves.', swatches: [] };
    return {
      note: 'Distance to where all influences put a vertex',
      swatches: [swatch(zeroColor, 'unmoved')],
      scale: { gradient: gradientOf(errorRamp), texts: ['0', rounded(truncation.largest, 3)] },
    };
  },
};

/** The error of a sum that the readers warn of. */
const warned = 1e-3;

function swatch(color: Bytes, text: string) {
  return { color: cssColor(color), text };
}

/** Every sixteenth color is close enough, since they change evenly. */
function gradientOf(ramp: readonly Bytes[]): string {
  const stops = ramp.filter((_, index) => index % 16 === 0 || index === ramp.length - 1);
  return `linear-gradient(to right, ${stops.map(cssColor).join(', ')})`;
}
