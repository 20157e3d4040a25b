import type { OddValues } from './odd-values.ts';
import { PlainRows } from './plain-rows.ts';
import type { Scanner } from './scanner.ts';

/** Rows of numbers of equal size, from `NAME N { … }`. */
export interface Section {
  /** (count × size) */
  readonly values: Float32Array;
  readonly count: number;
  /** (count) one-based line of each row's first number. */
  readonly lines: Uint32Array;
}

/**
 * Reads `N { … }` after its keyword: N rows of `size` numbers. If the count differs from the number
 * of rows, that is an error, which is found before an array of that size is allocated.
 *
 * @param odd collects values that are not numbers; without it they are errors
 */
export function readRows(
  scanner: Scanner,
  name: string,
  size: number,
  most: number,
  odd?: OddValues,
): Section | undefined {
  const count = scanner.count(`rows of ${name}`, size * 2, most);
  if (!scanner.sound()) return undefined;
  const opened = scanner.openIfAny();
  const rows = new PlainRows(count, size, scanner.limits.coordinate);
  const { values, lines } = rows;
  for (;;) {
    if (values.length % size === 0) scanner.takePlain((numbers) => rows.read(numbers));
    const read = values.length;
    if (read === count * size) break;
    if (endsWithin(scanner, name, size, count, read)) return undefined;
    if (read % size === 0) lines.push(scanner.reader.line);
    values.push(odd?.take(scanner) === true ? NaN : scanner.thisNumber(name));
    if (!scanner.sound()) return undefined;
  }
  if (!closeRows(scanner, name, count, opened)) return undefined;
  return { values: values.finish(), count, lines: lines.finish() };
}

/** Whether a closing brace occurs instead of the next row, which is an error. */
export function endsEarly(scanner: Scanner, name: string, count: number, read: number): boolean {
  const mark = scanner.reader.mark();
  scanner.reader.next();
  if (scanner.reader.isClose) failShort(scanner, name, count, `${read}`);
  scanner.reader.back(mark);
  return !scanner.sound();
}

/**
 * Goes to the next number in rows of equal size. Returns whether a closing brace occurs instead,
 * which is an error.
 *
 * @param read the number of values so far
 */
export function endsWithin(
  scanner: Scanner,
  name: string,
  size: number,
  count: number,
  read: number,
): boolean {
  scanner.reader.next();
  if (!scanner.reader.isClose) return false;
  const rest = read % size;
  const part = rest === 0 ? '' : ` and ${rest} of ${size} numbers`;
  failShort(scanner, name, count, `${Math.floor(read / size)}${part}`);
  return true;
}

function failShort(scanner: Scanner, name: string, count: number, found: string): void {
  scanner.fail('count', `${count} rows of ${name}, as the file says`, found);
}

/** Reads the brace after the last row. Additional rows are an error and are not counted. */
export function closeRows(scanner: Scanner, name: string, count: number, opened: boolean): boolean {
  const mark = scanner.reader.mark();
  scanner.reader.next();
  const more = scanner.reader.looksNumeric;
  if (more) scanner.fail('count', `${count} rows of ${name}, as the file says`, 'more');
  scanner.reader.back(mark);
  return scanner.sound() && scanner.close(name, opened);
}
