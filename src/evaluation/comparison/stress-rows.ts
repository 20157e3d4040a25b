import { printable } from '../../core/diagnostics.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import { kernelById } from '../../skinning/registry.ts';
import { sixDigits } from './six-digits.ts';
import type { StressNumbers, StressSuite } from './stress.ts';
import type { StressPose } from './stress-poses.ts';

/** A pose of the suite in words: "Right elbow · bend 120°". */
export function stressLabel({ names }: Skeleton, { joint, motion, angle }: StressPose): string {
  const degrees = Number(degreesOf(angle).toFixed(1));
  return `${printable(names[joint]!, 60)} · ${motion} ${degrees < 0 ? '−' : ''}${Math.abs(degrees)}°`;
}

/** In degrees, without what rounding adds. */
function degreesOf(angle: number): number {
  const rounded = Number(((angle * 180) / Math.PI).toFixed(2));
  return rounded === 0 ? 0 : rounded;
}

/**
 * Lays a suite out as a table with one head: a row for each pose, in the order of the joints, and of
 * each quantity a column for each method.
 */
export function stressRows(
  { names }: Skeleton,
  { methods, size, rows }: StressSuite,
): (string | number | null)[][] {
  const shorts = methods.map((method) => kernelById(method).short);
  const quantities: readonly (readonly [string, (numbers: StressNumbers) => number | null])[] = [
    ['largest', ({ largest }) => sixDigits(largest)],
    ['largest / height', ({ largest }) => sixDigits(largest / size.height)],
    ['largest vertex', ({ largest, worst }) => (largest > 0 ? worst : null)],
    ['mean', ({ mean }) => sixDigits(mean)],
    ['mean / height', ({ mean }) => sixDigits(mean / size.height)],
    ['volume / rest', ({ volume }) => sixDigits(volume)],
  ];
  const head = quantities.flatMap(([quantity]) => shorts.map((short) => `${short} ${quantity}`));
  const body = rows.map(({ pose: { joint, motion, angle }, numbers }) => [
    names[joint]!,
    motion,
    degreesOf(angle),
    ...quantities.flatMap(([, valueOf]) => numbers.map(valueOf)),
  ]);
  return [['joint', 'motion', 'degrees', ...head], ...body];
}
