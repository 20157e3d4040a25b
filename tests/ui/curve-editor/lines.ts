import type {
  ClipParts,
  Extrapolation,
  KeyParts,
  ScalarChannelParts,
  Tangent,
} from '../../../src/core/motion/clip-parts.ts';
import { channelKey } from '../../../src/core/motion/targets.ts';
import { DofKind } from '../../../src/core/skeleton.ts';
import { type PlotLine, plotLines } from '../../../src/ui/curve-editor/plot-lines.ts';
import type { Plot } from '../../../src/ui/curve-editor/plot.ts';

/** A key at a time with a value; its tangents are smooth if none are given. */
export function key(time: number, value: number, tangent: Tangent = 'smooth'): KeyParts {
  return { time, value, tangentIn: tangent, tangentOut: tangent };
}

/** The curve of a hinge of the first joint about an axis. */
export function hinge(
  axis: 0 | 1 | 2,
  keys: readonly KeyParts[],
  rule: Extrapolation = 'constant',
): ScalarChannelParts {
  const target = { of: 'value', joint: 0, kind: DofKind.hinge, axis } as const;
  return { target, before: rule, after: rule, keys };
}

export function clipOf(...channels: readonly ScalarChannelParts[]): ClipParts {
  return { file: 'a.anim', name: 'a', start: 0, end: 2, fps: 30, channels };
}

/** The channel's line as the plot has it. */
export function lineOf(channel: ScalarChannelParts, isNormalized = false): PlotLine {
  const color = 'x';
  const shown = {
    key: channelKey(channel.target!),
    name: 'joint X',
    color,
    isDotted: false,
    unit: 'angle',
    channel: channel as ScalarChannelParts & { target: NonNullable<typeof channel.target> },
  } as const;
  return plotLines([shown], isNormalized)[0]!;
}

/** 100 pixels a second, and 100 a unit of value, which is 0 in the middle. */
export const plot: Plot = { time: [0, 4], values: [-1, 1], width: 400, height: 200 };
