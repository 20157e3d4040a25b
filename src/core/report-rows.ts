import type { DiagnosticLog, Place } from './diagnostics.ts';
import type { Skin } from './skin.ts';

/** Packed weights, and the points whose rows are reported. */
export interface SkinRows {
  readonly skin: Pick<Skin, 'start' | 'entries' | 'weights'>;
  readonly zeroRows: readonly number[];
  readonly negativeRows: readonly number[];
  readonly unevenRows: readonly { readonly point: number; readonly sum: number }[];
}

/**
 * Reports unusual weights; they are used nevertheless.
 *
 * @param lines (pointCount) line of each row in its file
 */
export function reportRows(
  rows: SkinRows,
  lines: Uint32Array | undefined,
  log: DiagnosticLog,
): void {
  const { zeroRows, negativeRows, unevenRows } = rows;
  if (zeroRows.length > 0) {
    log.warn({
      code: 'character/weight-zero',
      ...linePlace(lines, zeroRows[0]!),
      expected: 'at least one weight for every vertex',
      found: `none for ${listed(zeroRows)}`,
      effect: 'they follow the root rigidly',
    });
  }
  if (negativeRows.length > 0) {
    log.warn({
      code: 'character/weight-negative',
      ...linePlace(lines, negativeRows[0]!),
      expected: 'weights of at least 0',
      found: `negative ones for ${listed(negativeRows)}`,
      effect: 'they are kept as they are',
    });
  }
  if (unevenRows.length > 0) {
    const byRisingSum = unevenRows.toSorted((a, b) => a.sum - b.sum);
    const [least, most] = [byRisingSum[0]!, byRisingSum.at(-1)!];
    const worst = 1 - least.sum > most.sum - 1 ? least : most;
    const range = [...new Set([least, most].map(({ sum }) => Number(sum.toPrecision(6))))];
    log.warn({
      code: 'character/weight-sum',
      ...linePlace(lines, worst.point),
      expected: 'weights that sum to 1 for every vertex',
      found: `${range.join(' to ')} for ${unevenRows.length}`,
      effect:
        `they are used as they are, vertex ${worst.point + 1} being the farthest off; ` +
        '"normalize weights" divides them by their sum',
    });
  }
}

/** The place of a point's row in its file, if the file has lines. */
export function linePlace(lines: Uint32Array | undefined, point: number): Place {
  const line = lines?.[point];
  return line === undefined ? {} : { line };
}

/**
 * The number of points and the first few of them, counted from 1 as in OBJ files; short, because
 * messages are cut.
 */
function listed(points: readonly number[]): string {
  const shown = points.slice(0, 3).map((point) => point + 1);
  const more = points.length > shown.length ? ', …' : '';
  return `${points.length}: vertex ${shown.join(', ')}${more}`;
}
