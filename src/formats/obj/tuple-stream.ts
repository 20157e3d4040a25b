import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { checkFloat32, largestFloat32 } from '../text/check-float32.ts';
import { growFloat32 } from '../text/growable.ts';
import type { LineReader } from '../text/line-reader.ts';

const effect = 'the mesh is not used';

/** How programs write NaN and infinities: `nan`, `-nan(ind)`, `1.#QNAN`, `1,#INF`, `inf`. */
const isNotANumber = /^[+-]?(nan|inf|\d[.,]#)/i;

export interface TupleKind {
  /** For messages: "vertices". */
  readonly what: string;
  /** Names of the values, for messages. */
  readonly names: readonly string[];
  /** The minimum number of values, all of them by default; missing ones are 0. */
  readonly fewest?: number;
  /** What is left out when a tuple is not numeric: corners, or triangles of the mesh. */
  readonly sparedBy: 'corners' | 'triangles';
  /** The largest number of tuples in a file. */
  readonly most: number;
  /** The largest magnitude of a value. */
  readonly largest?: number;
}

/** One kind of tuple to which faces refer: `v`, `vt` or `vn`. */
export class TupleStream {
  private readonly values: ReturnType<typeof growFloat32>;
  private readonly kind: TupleKind;
  private readonly size: number;
  private readonly fewest: number;
  private readonly largest: number;
  private tupleCount = 0;
  private allSound = true;
  private full = false;
  private oddCount = 0;
  private firstOdd: { readonly line: number; readonly source: string } | undefined;

  /** @param valueCount about as many as are expected */
  constructor(kind: TupleKind, valueCount?: number) {
    this.values = growFloat32(valueCount);
    this.kind = kind;
    this.size = kind.names.length;
    this.fewest = kind.fewest ?? kind.names.length;
    this.largest = kind.largest ?? largestFloat32;
  }

  get count(): number {
    return this.tupleCount;
  }

  /** Whether a tuple exceeded the limit, which has been reported. */
  get isFull(): boolean {
    return this.full;
  }

  value(index: number): number {
    return this.values.at(index);
  }

  /** Whether all values of a tuple are numbers. */
  isSound(tuple: number): boolean {
    for (let i = 0; i < this.size; i++) {
      if (Number.isNaN(this.values.at(tuple * this.size + i))) return false;
    }
    return true;
  }

  /** Whether all values of all tuples so far are numbers. */
  get isAllSound(): boolean {
    return this.allSound;
  }

  /**
   * Adds a tuple of plain numbers, of which there may be more than it needs. Returns false, without
   * effect, if there are too few, if one is too large, or if there is no room for another tuple.
   */
  add(numbers: Float64Array, count: number): boolean {
    const { size, largest } = this;
    if (count < this.fewest || this.tupleCount >= this.kind.most) return false;
    const values = this.values.reserve(size);
    const start = this.values.length;
    for (let i = 0; i < size; i++) {
      const value = i < count ? numbers[i]! : 0;
      if (!(value <= largest && value >= -largest)) return false;
      values[start + i] = value;
    }
    this.values.length = start + size;
    this.tupleCount++;
    return true;
  }

  /** Reports how many tuples are not numbers, at the first of them. */
  reportOddities(log: DiagnosticLog): void {
    if (!this.firstOdd || this.kind.sparedBy === 'triangles') return;
    log.warn({
      code: 'obj/number',
      ...this.firstOdd,
      expected: `${this.kind.what} that are numbers`,
      found: `${this.oddCount} that are not`,
      effect: 'corners go without them',
    });
  }

  /** Reads the rest of the current line; additional numbers (w, colors) are ignored. */
  read(reader: LineReader, log: DiagnosticLog): void {
    const { names, most } = this.kind;
    const { fewest, largest } = this;
    if (this.count >= most) {
      this.full = true;
      const expected = `at most ${most} ${this.kind.what}`;
      log.error({ code: 'obj/limit', ...reader.linePlace, expected, found: 'more', effect });
      return;
    }
    this.tupleCount++;
    let isOdd = false;
    for (let index = 0; index < names.length; index++) {
      if (reader.token()) {
        const value = reader.number();
        if (Math.abs(value) <= largest) {
          this.values.push(value);
          continue;
        }
        this.values.push(NaN);
        this.allSound = false;
        if (this.isOdd(value, reader)) isOdd = true;
        else {
          checkFloat32(reader, { what: names[index]!, area: 'obj', effect, largest }, log);
        }
        continue;
      }
      this.values.push(0);
      if (index >= fewest) continue;
      const [expected, found] = [`${fewest} numbers`, `${index}`];
      log.error({ code: 'obj/field-count', ...reader.linePlace, expected, found, effect });
    }
    if (isOdd) this.noteOdd(reader, log);
  }

  /**
   * Whether the token says that it is not a number. Where only corners need it, anything else counts
   * as that too: words, and numbers past all that a float32 holds.
   */
  private isOdd(value: number, reader: LineReader): boolean {
    if (this.kind.sparedBy === 'corners') return true;
    return Number.isNaN(value) && isNotANumber.test(reader.text());
  }

  /**
   * A vertex is reported with its line, because rows of weights count it; other tuples once, with a
   * count.
   */
  private noteOdd(reader: LineReader, log: DiagnosticLog): void {
    this.oddCount++;
    this.firstOdd ??= reader.linePlace;
    if (this.kind.sparedBy === 'corners') return;
    log.errorOfPart({
      code: 'obj/number',
      ...reader.linePlace,
      expected: `${this.kind.what} that are numbers`,
      found: 'one that is not',
      effect: 'the mesh is shown without its triangles',
    });
  }

  /** Values that are not numbers are 0 here; no corner refers to them. */
  finish(): Float32Array {
    const values = this.values.finish();
    return this.oddCount === 0 ? values : values.map((value) => (Number.isNaN(value) ? 0 : value));
  }
}

export interface ObjStreams {
  readonly positions: TupleStream;
  readonly uvs: TupleStream;
  readonly normals: TupleStream;
}
