import { growFloat32, growUint32 } from '../text/growable.ts';
import type { PlainNumbers } from '../text/plain-numbers.ts';

/** Rows of equally many numbers, nearly all of which are plain in most files. */
export class PlainRows {
  /** (count × size) */
  readonly values: ReturnType<typeof growFloat32>;
  /** (count) one-based line of each row's first number. */
  readonly lines: ReturnType<typeof growUint32>;
  private readonly count: number;
  private readonly row: Float64Array;
  private readonly largest: number;

  constructor(count: number, size: number, largest: number) {
    this.values = growFloat32(count * size);
    this.lines = growUint32(count);
    this.count = count;
    this.row = new Float64Array(size);
    this.largest = largest;
  }

  /** Reads rows of plain numbers, none of them too large, up to the first other one. */
  read(numbers: PlainNumbers): void {
    const { row, lines } = this;
    while (lines.length < this.count) {
      numbers.skipBlanks();
      const { at, line } = numbers;
      if (numbers.numbers(row, row.length) < row.length || !this.add()) {
        numbers.at = at;
        numbers.line = line;
        return;
      }
      lines.push(line);
    }
  }

  private add(): boolean {
    const { row, values, largest } = this;
    const storage = values.reserve(row.length);
    const start = values.length;
    for (let i = 0; i < row.length; i++) {
      const value = row[i]!;
      if (!(value <= largest && value >= -largest)) return false;
      storage[start + i] = value;
    }
    values.length = start + row.length;
    return true;
  }
}
