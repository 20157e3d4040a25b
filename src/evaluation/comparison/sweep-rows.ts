import { kernelById } from '../../skinning/registry.ts';
import type { Sweep } from './sweep.ts';
import { sixDigits } from './six-digits.ts';

/**
 * Lays a sweep out as a table with one head: a row for each angle, in degrees, with the volumes by all
 * methods and then their sections, as parts of those at rest.
 */
export function sweepRows({ angles, curves }: Sweep): (string | number | null)[][] {
  const names = curves.map(({ method }) => kernelById(method).short);
  const head = [
    'degrees',
    ...names.map((name) => `${name} volume / rest`),
    ...names.map((name) => `${name} section / rest`),
  ];
  const rows = angles.map((angle, i) => [
    sixDigits((angle * 180) / Math.PI),
    ...curves.map(({ volumes }) => sixDigits(volumes[i]!)),
    ...curves.map(({ sections }) => sixDigits(sections[i]!)),
  ]);
  return [head, ...rows];
}
