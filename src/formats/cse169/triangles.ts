import type { Limits } from '../../core/limits.ts';
import { growUint32 } from '../text/growable.ts';
import type { Scanner } from './scanner.ts';
import { closeRows, endsWithin } from './sections.ts';

export interface Triangles {
  /** (triangleCount × 3) */
  readonly corners: Uint32Array;
  /** (triangleCount) one-based line of each triangle's last corner. */
  readonly lines: Uint32Array;
}

/**
 * Reads `M { a b c … }`, zero-based. Triangles that use a vertex twice are left out, and a warning
 * counts them.
 */
export function readTriangles(scanner: Scanner, limits: Limits): Triangles | undefined {
  const count = scanner.count('triangles', 6, limits.triangleCount);
  if (!scanner.sound()) return undefined;
  const opened = scanner.openIfAny();
  const corners = growUint32();
  const lines = growUint32();
  let degenerate = 0;
  for (let triangle = 0; triangle < count; triangle++) {
    const [a, b, c] = [0, 1, 2].map((corner) => {
      if (!scanner.sound()) return NaN;
      if (endsWithin(scanner, 'triangles', 3, count, triangle * 3 + corner)) return NaN;
      return scanner.thisIndex(`a corner of triangle ${triangle}`, limits.pointCount - 1);
    });
    if (!scanner.sound()) return undefined;
    if (a === b || b === c || c === a) degenerate++;
    else {
      for (const corner of [a!, b!, c!]) corners.push(corner);
      lines.push(scanner.reader.line);
    }
  }
  if (!closeRows(scanner, 'triangles', count, opened)) return undefined;
  if (degenerate > 0) {
    const found = `${degenerate} with a corner twice`;
    scanner.warn('degenerate', 'triangles of three corners', found, 'they are left out');
  }
  return { corners: corners.finish(), lines: lines.finish() };
}
