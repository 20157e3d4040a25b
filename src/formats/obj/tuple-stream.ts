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
  private readonly values = growFloat32();
  private readonly kind: TupleKind;
  private full = false;
  private oddCount = 0;
  private firstOdd: { readonly line: number; readonly source: string } | undefined;

  constructor(kind: TupleKind) {
    this.kind = kind;
  }

  get count(): number {
    return this.values.length / this.kind.names.length;
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
    const { length } = this.kind.names;
    for (let i = 0; i < length; i++) {
      if (Number.isNaN(this.values.at(tuple * length + i))) return false;
    }
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
    const { names, fewest = names.length, most, largest = largestFloat32 } = this.kind;
    if (this.count >= most) {
      this.full = true;
      const expected = `at most ${most} ${this.kind.what}`;
      log.error({ code: 'obj/limit', ...reader.linePlace, expected, found: 'more', effect });
      return;
    }
    let isOdd = false;
    for (let index = 0; index < names.length; index++) {
      if (reader.token()) {
        const value = reader.number();
        if (Math.abs(value) <= largest) this.values.push(value);
        else if (this.isOdd(value, reader)) {
          this.values.push(NaN);
          isOdd = true;
        } else {
          const what = names[index]!;
          this.values.push(checkFloat32(reader, { what, area: 'obj', effect, largest }, log));
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
   * Whether the token says that it is not a number, or is a number past all that a float32 holds where
   * only corners need it.
   */
  private isOdd(value: number, reader: LineReader): boolean {
    if (Number.isNaN(value)) return isNotANumber.test(reader.text());
    return this.kind.sparedBy === 'corners' && Math.abs(value) > largestFloat32;
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
