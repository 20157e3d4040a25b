import type { KernelId } from '../skinning/method.ts';

/** A method that is compared: a kernel, or what each character has of its own. */
export type ComparedMethod = KernelId | 'own';

export const comparisonLayouts = ['wipe', 'side by side'] as const;

/** How one pose is shown under several methods at once. */
export interface Comparison {
  /** From two to `mostMethods` different ones, from the left. */
  readonly methods: readonly ComparedMethod[];
  /** Whether each method has a part of one picture, or a picture of its own. */
  readonly layout: (typeof comparisonLayouts)[number];
  /**
   * Where one method ends and the next begins under a wipe: parts of the view's width from the left,
   * increasing; one fewer than methods.
   */
  readonly wipes: readonly number[];
  /** The method from which differences are counted: an index of the methods. */
  readonly base: number;
  /** Whether the other methods show their differences from it in color. */
  readonly heatMap: boolean;
  /** Whether all methods blend with rows of weights that sum to 1. */
  readonly normalizeRows: boolean;
}

export const mostMethods = 4;

/** A comparison as it opens. */
export function comparisonOf(methods: readonly ComparedMethod[]): Comparison {
  return {
    methods,
    layout: 'wipe',
    wipes: evenWipes(methods.length),
    base: 0,
    heatMap: false,
    normalizeRows: false,
  };
}

/** Replaces the methods; the base stays the same one where it can. */
export function withMethods(
  comparison: Comparison,
  methods: readonly ComparedMethod[],
): Comparison {
  const isSameCount = methods.length === comparison.methods.length;
  return {
    ...comparison,
    methods,
    wipes: isSameCount ? comparison.wipes : evenWipes(methods.length),
    base: Math.max(0, methods.indexOf(comparison.methods[comparison.base]!)),
  };
}

/** Moves one of the wipes, between the two beside it. */
export function withWipe(comparison: Comparison, index: number, place: number): Comparison {
  const { wipes } = comparison;
  const [least, most] = [wipes[index - 1] ?? 0, wipes[index + 1] ?? 1];
  const moved = Math.min(most, Math.max(least, place));
  return { ...comparison, wipes: wipes.map((wipe, i) => (i === index ? moved : wipe)) };
}

/** Every method has the same width. */
function evenWipes(methodCount: number): number[] {
  return Array.from({ length: methodCount - 1 }, (_, index) => (index + 1) / methodCount);
}
