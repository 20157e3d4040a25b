import type { Limits } from '../../core/limits.ts';
import { growUint32 } from '../text/growable.ts';
import type { PlainNumbers } from '../text/plain-numbers.ts';
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
  const corners = growUint32(count * 3);
  const lines = growUint32(count);
  const corner = new Int32Array(3);
  let degenerate = 0;
  for (let triangle = 0; triangle < count; triangle++) {
    scanner.takePlain((numbers) => {
      while (triangle < count && readPlainTriangle(numbers)) {
        add(numbers.line);
        triangle++;
      }
    });
    if (triangle === count) break;
    readTriangle(triangle);
    if (!scanner.sound()) return undefined;
    add(scanner.reader.line);
  }
  if (!closeRows(scanner, 'triangles', count, opened)) return undefined;
  if (degenerate > 0) {
    const found = `${degenerate} with a corner twice`;
    scanner.warn('degenerate', 'triangles of three corners', found, 'they are left out');
  }
  return { corners: corners.finish(), lines: lines.finish() };
  /** Reads three plain indices; returns false, without effect, if something else comes. */
  function readPlainTriangle(numbers: PlainNumbers): boolean {
    const { at, line } = numbers;
    const most = limits.pointCount;
    const isRead = numbers.indices(corner, 3) === 3;
    if (isRead && corner[0]! < most && corner[1]! < most && corner[2]! < most) return true;
    numbers.at = at;
    numbers.line = line;
    return false;
  }

  function readTriangle(triangle: number): void {
    for (let i = 0; i < 3 && scanner.sound(); i++) {
      if (endsWithin(scanner, 'triangles', 3, count, triangle * 3 + i)) return;
      corner[i] = scanner.thisIndex(`a corner of triangle ${triangle}`, limits.pointCount - 1);
    }
  }

  function add(line: number): void {
    const [a, b, c] = [corner[0]!, corner[1]!, corner[2]!];
    if (a === b || b === c || c === a) {
      degenerate++;
      return;
    }
    const storage = corners.reserve(3);
    storage[corners.length++] = a;
    storage[corners.length++] = b;
    storage[corners.length++] = c;
    lines.push(line);
  }
}
