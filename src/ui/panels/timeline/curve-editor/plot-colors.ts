import { otherColorCount } from '../../../curve-editor/shown-curves.ts';

/** The colors of the plot in the present theme, as a canvas takes them. */
export interface PlotColors {
  readonly of: (name: string) => string;
}

/** Every color of the plot; each has a custom property `--NAME` in the style sheet. */
const names = [
  ...['x', 'y', 'z', 'text', 'quiet', 'line', 'strong-line', 'beyond', 'surface', 'accent'],
  ...Array.from({ length: otherColorCount }, (_, i) => `other-${i}`),
];

/**
 * Reads the colors from the style sheet. A canvas does not know `light-dark()`, so an element
 * resolves them.
 *
 * @param probe an element of the plot, out of sight
 */
export function readColors(probe: HTMLElement): PlotColors {
  const colors = new Map(
    names.map((name) => {
      probe.style.color = `var(--plot-${name})`;
      return [name, getComputedStyle(probe).color];
    }),
  );
  return { of: (name) => colors.get(name) ?? 'gray' };
}
