import type { Triple } from '../../core/oklab.ts';

type Matrix = readonly [Triple, Triple, Triple];

/**
 * How eyes without one kind of cones see colors in linear light: protanopia, deuteranopia and
 * tritanopia. From the table of Machado, Oliveira and Fernandes, “A physiologically-based model for
 * simulation of color vision deficiency” (2009), at severity 1.
 */
export const dichromacies: readonly Matrix[] = [
  [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
];

/** The linear light that looks to others as a color looks to these eyes, within the display's range. */
export function seenAs(matrix: Matrix, light: Triple): Triple {
  const [r, g, b] = matrix.map((row) => {
    const sum = row[0] * light[0] + row[1] * light[1] + row[2] * light[2];
    return Math.min(1, Math.max(0, sum));
  });
  return [r!, g!, b!];
}
