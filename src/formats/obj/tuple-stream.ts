import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { checkFloat32 } from '../text/check-float32.ts';
import { growFloat32 } from '../text/growable.ts';
import type { LineReader } from '../text/line-reader.ts';

const effect = 'the mesh is not used';

export interface TupleKind {
  /** For messages: "vertices". */
  readonly what: string;
  /** Of the values, for messages. */
  readonly names: readonly string[];
  /** How many of them must be there, all by default; the rest is 0. */
  readonly fewest?: number;
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

  /** Reads the rest of the current line; further numbers (w, colours) are left out. */
  read(reader: LineReader, log: DiagnosticLog): void {
    const { names, fewest = names.length, most, largest } = this.kind;
    if (this.count >= most) {
      this.full = true;
      const expected = `at most ${most} ${this.kind.what}`;
      log.error({ code: 'obj/limit', ...reader.linePlace, expected, found: 'more', effect });
      return;
    }
    for (const [index, what] of names.entries()) {
      if (reader.token()) {
        this.values.push(checkFloat32(reader, { what, area: 'obj', effect, largest }, log));
        continue;
      }
      this.values.push(0);
      if (index >= fewest) continue;
      const [expected, found] = [`${fewest} numbers`, `${index}`];
      log.error({ code: 'obj/field-count', ...reader.linePlace, expected, found, effect });
    }
  }

  finish(): Float32Array {
    return this.values.finish();
  }
}

export interface ObjStreams {
  readonly positions: TupleStream;
  readonly uvs: TupleStream;
  readonly normals: TupleStream;
}
