import type { CutRole, CuttingPlane } from '../../document/cutting.ts';
import type { PlaneLine } from '../../evaluation/comparison/plane-lines.ts';
import { formatSize } from '../number-text.ts';

/** An outline of the figure, by one method. */
export interface FigureOutline {
  readonly role: CutRole;
  /** The method's name. */
  readonly label: string;
  readonly lines: readonly PlaneLine[];
  /** Whether the method is still loading or being prepared. */
  readonly isPending: boolean;
}

/** A figure: the outlines of a posed character in a plane. */
export interface Figure {
  readonly characterName: string;
  readonly jointName: string;
  readonly plane: CuttingPlane;
  readonly outlines: readonly FigureOutline[];
}

/** The square of the plane that a drawing shows, in model units. */
export interface FigureView {
  readonly center: readonly [right: number, rise: number];
  readonly half: number;
}

/** The side of the drawing, in its own pixels; both directions have one scale. */
export const figureSide = 300;

/** A drawing around the joint shows so many reaches of the plane to each side. */
const aroundJoint = 1.1;
const margin = 1.08;

export function viewOfJoint({ plane }: Figure): FigureView {
  return { center: [0, 0], half: aroundJoint * plane.reach };
}

/** The smallest view with a margin that shows all outlines. */
export function viewOfAll(figure: Figure): FigureView {
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (const { places } of figure.outlines.flatMap(({ lines }) => lines)) {
    for (let i = 0; i < places.length; i++) {
      low[i % 2] = Math.min(low[i % 2]!, places[i]!);
      high[i % 2] = Math.max(high[i % 2]!, places[i]!);
    }
  }
  if (!(low[0]! <= high[0]!)) return viewOfJoint(figure);
  const half = (margin * Math.max(high[0]! - low[0]!, high[1]! - low[1]!)) / 2;
  return { center: [(low[0]! + high[0]!) / 2, (low[1]! + high[1]!) / 2], half };
}

/** The view that shows the same place of the plane at a part of its sides, nearer by a factor below 1. */
export function zoomedAt(
  { center, half }: FigureView,
  factor: number,
  [x, y]: readonly [number, number],
): FigureView {
  const kept = 2 * half * (1 - factor);
  return {
    half: half * factor,
    center: [center[0] + (x - 0.5) * kept, center[1] - (y - 0.5) * kept],
  };
}

/** The view after the drawing was moved right and down by parts of its side. */
export function panned(
  { center: [right, rise], half }: FigureView,
  [x, y]: readonly [number, number],
): FigureView {
  return { half, center: [right - x * 2 * half, rise + y * 2 * half] };
}

/** The lines of an outline as the data of a path of SVG. */
export function pathData(lines: readonly PlaneLine[], { center, half }: FigureView): string {
  const scale = figureSide / (2 * half);
  const place = (right: number, rise: number): string =>
    `${rounded(figureSide / 2 + (right - center[0]) * scale)} ${rounded(figureSide / 2 - (rise - center[1]) * scale)}`;
  return lines
    .map(({ places, isClosed }) => {
      const corners: string[] = [];
      for (let i = 0; i < places.length; i += 2) corners.push(place(places[i]!, places[i + 1]!));
      return `M${corners.join('L')}${isClosed ? 'Z' : ''}`;
    })
    .join('');
}

/** A length of 1, 2 or 5 times a power of ten that fits a drawing, for its scale bar. */
export function scaleBar({ half }: FigureView): { readonly pixels: number; readonly text: string } {
  const most = (2 * half) / 3;
  const power = 10 ** Math.floor(Math.log10(most));
  const length = power * [5, 2, 1].find((step) => step * power <= most)!;
  const text = `${formatSize(length)} ${length === 1 ? 'unit' : 'units'}`;
  return { pixels: rounded((length * figureSide) / (2 * half)), text };
}

function rounded(place: number): number {
  return Math.round(place * 100) / 100;
}
