import { growFloat32 } from '../text/growable.ts';
import type { Scanner } from './scanner.ts';

/** Numbers in rows of equal size, as `NAME N { … }` has them. */
export interface Section {
  /** (count × size) */
  readonly values: Float32Array;
  readonly count: number;
}

/**
 * Reads `N { … }` after its keyword: N rows of `size` numbers. A count that is not that of the rows
 * is an error, found before anything of that size is made.
 */
export function readRows(
  scanner: Scanner,
  name: string,
  size: number,
  most: number,
): Section | undefined {
  const count = scanner.count(`rows of ${name}`, size * 2, most);
  if (!scanner.sound()) return undefined;
  const opened = scanner.openIfAny();
  const values = growFloat32();
  for (let i = 0; i < count * size; i++) {
    if (i % size === 0 && endsEarly(scanner, name, count, i / size)) return undefined;
    values.push(scanner.number(name));
    if (!scanner.sound()) return undefined;
  }
  return closeRows(scanner, name, count, opened) ? { values: values.finish(), count } : undefined;
}

/** Whether a closing brace stands where the next row should; that is an error. */
export function endsEarly(scanner: Scanner, name: string, count: number, read: number): boolean {
  const mark = scanner.reader.mark();
  scanner.reader.next();
  if (scanner.reader.isClose) {
    scanner.fail('count', `${count} rows of ${name}, as the file says`, `${read}`);
  }
  scanner.reader.back(mark);
  return !scanner.sound();
}

/** The brace after the last row; where there are more rows, an error that counts no further. */
export function closeRows(scanner: Scanner, name: string, count: number, opened: boolean): boolean {
  const mark = scanner.reader.mark();
  scanner.reader.next();
  const more = scanner.reader.looksNumeric;
  if (more) scanner.fail('count', `${count} rows of ${name}, as the file says`, 'more');
  scanner.reader.back(mark);
  return scanner.sound() && scanner.close(name, opened);
}
