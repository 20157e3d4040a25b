import type { DiagnosticLog, Place } from './diagnostics.ts';
import type { Skin } from './skin.ts';

/** Packed weights, and the points whose rows are worth a word. */
export interface SkinRows {
  readonly skin: Pick<Skin, 'start' | 'entries' | 'weights'>;
  readonly zeroRows: readonly number[];
  readonly negativeRows: readonly number[];
  readonly unevenRows: readonly { readonly point: number; readonly sum: number }[];
}

/**
 * Says what is odd about the weights; none of it keeps them from being used.
 *
 * @param lines (pointCount) of the rows in their file
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

/** Where the row of a point stands, as far as its file has lines. */
export function linePlace(lines: Uint32Array | undefined, point: number): Place {
  const line = lines?.[point];
  return line === undefined ? {} : { line };
}

/** How many, and the first few, one-based as OBJ counts them; short, since messages are cut. */
function listed(points: readonly number[]): string {
  const shown = points.slice(0, 3).map((point) => point + 1);
  const more = points.length > shown.length ? ', …' : '';
  return `${points.length}: vertex ${shown.join(', ')}${more}`;
}
