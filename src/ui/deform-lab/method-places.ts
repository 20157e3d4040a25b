import type { Comparison } from '../../document/comparison.ts';

/** Where each method's part of the view begins and ends, as parts of its width from the left. */
export function methodPlaces({
  methods,
  layout,
  wipes,
}: Comparison): readonly (readonly [from: number, to: number])[] {
  const edges =
    layout === 'wipe'
      ? [0, ...wipes, 1]
      : [...methods.keys(), methods.length].map((column) => column / methods.length);
  return methods.map((_, index) => [edges[index]!, edges[index + 1]!]);
}
