import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { Limits } from '../../core/limits.ts';
import type { BinaryReader, RecordArray } from '../binary/binary-reader.ts';
import { Findings } from './findings.ts';

/** Indices have 16 bits. */
const indexCount = 65_536;

/**
 * Reads the corners of the triangles (triangleCount × 3) and swaps the second and third corner of
 * each, because mirroring reverses the sides of a triangle.
 */
export function readFaces(
  reader: BinaryReader,
  pointCount: number,
  log: DiagnosticLog,
  limits: Limits,
  effect: string,
): Uint32Array | undefined {
  const array = reader.array(4, 2, 'indices of vertices');
  if (!array) return undefined;
  const { count, offset, records } = array;
  if (count % 3 !== 0) {
    const expected = 'three indices for each triangle';
    log.error({ code: 'pmd/count', offset, expected, found: `${count}`, effect });
    return undefined;
  }
  if (count / 3 > limits.triangleCount) {
    const expected = `at most ${limits.triangleCount} triangles`;
    log.error({ code: 'pmd/limit', offset, expected, found: `${count / 3}`, effect });
    return undefined;
  }
  const corners = new Uint32Array(count);
  for (let first = 0; first < count; first += 3) {
    for (let i = 0; i < 3; i++) {
      const point = records.u16((first + i) * 2);
      if (point >= pointCount) {
        const place = { offset: records.offset + (first + i) * 2 };
        const expected = `vertices from 0 to ${pointCount - 1}`;
        const found = `${point}, triangle ${first / 3}`;
        log.error({ code: 'pmd/index', ...place, expected, found, effect });
      }
      corners[i === 0 ? first : first + 3 - i] = point;
    }
  }
  if (!log.failed) warnOfFaces(array, corners, pointCount, log);
  return corners;
}

function warnOfFaces(
  { count, offset, records }: RecordArray,
  corners: Uint32Array,
  pointCount: number,
  log: DiagnosticLog,
): void {
  if (count === 0 && pointCount > 0) {
    const effect = 'the vertices are kept, and nothing is drawn';
    log.warn({ code: 'pmd/empty', offset, expected: 'triangles', found: 'none', effect });
  }
  if (pointCount > indexCount) {
    const expected = `at most ${indexCount} vertices, which is what the indices reach`;
    const effect = 'the others belong to no triangle';
    log.warn({ code: 'pmd/limit', offset, expected, found: `${pointCount}`, effect });
  }
  const degenerate = new Findings();
  for (let first = 0; first < corners.length; first += 3) {
    const [a, b, c] = [corners[first]!, corners[first + 1]!, corners[first + 2]!];
    if (a !== b && b !== c && c !== a) continue;
    degenerate.add(records.offset + first * 2, `triangle ${first / 3}`);
  }
  const expected = 'triangles of three different vertices';
  degenerate.warn(log, 'pmd/degenerate', expected, 'nothing of them is seen');
}
