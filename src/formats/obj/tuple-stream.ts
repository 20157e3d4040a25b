import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { checkFloat32, largestFloat32 } from '../text/check-float32.ts';
import { growFloat32 } from '../text/growable.ts';
import type { LineReader } from '../text/line-reader.ts';

const effect = 'the mesh is not used';

/** As programs write what is no number, and the infinities: `nan`, `-nan(ind)`, `1.#QNAN`, `1,#INF`, `inf`. */
const isNotANumber = /^[+-]?(nan|inf|\d[.,]#)/i;

export interface TupleKind {
  /** For messages: "vertices". */
  readonly what: string;
  /** Of the values, for messages. */
  readonly names: readonly string[];
  /** How many of them must be there, all by default; the rest is 0. */
  readonly fewest?: number;
  /** What goes without a tuple that is not numbers: corners, or triangles of the mesh. */
  readonly sparedBy: 'corners' | 'triangles';
  /** How many tuples a file may have. */
  readonly most: number;
  /** The largest magnitude of a value. */
  readonly largest?: number;
}

/** One kind of tuple that faces refer to: `v`, `vt` or `vn`. */
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

  /** Whether there was one too many, which was said. */
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

  /** Says how many tuples are not numbers, at the first of them. */
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

  /** Reads the rest of the current line; further numbers (w, colors) are left out. */
  read(reader: LineReader, log: DiagnosticLog): void {
    const { names, fewest = names.length, most, largest } = this.kind;
    if (this.count >= most) {
      this.full = true;
      const expected = `at most ${most} ${this.kind.what}`;
      log.error({ code: 'obj/limit', ...reader.linePlace, expected, found: 'more', effect });
      return;
    }
    let isOdd = false;
    for (const [index, what] of names.entries()) {
      if (reader.token()) {
        if (this.isOdd(reader)) {
          this.values.push(NaN);
          isOdd = true;
          continue;
        }
        this.values.push(checkFloat32(reader, { what, area: 'obj', effect, largest }, log));
        continue;
      }
      this.values.push(0);
      if (index >= fewest) continue;
      const [expected, found] = [`${fewest} numbers`, `${index}`];
      log.error({ code: 'obj/field-count', ...reader.linePlace, expected, found, effect });
    }
    if (isOdd) this.noteOdd(reader, log);
  }

  /** Whether the token says that it is no number, or is one too large where only corners need it. */
  private isOdd(reader: LineReader): boolean {
    const value = reader.number();
    if (Number.isNaN(value)) return isNotANumber.test(reader.text());
    return this.kind.sparedBy === 'corners' && Math.abs(value) > largestFloat32;
  }

  /** A vertex is told with its line, as rows of weights count it; the rest once, with a count. */
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

  /** What is no number is 0 here; no corner refers to it. */
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
