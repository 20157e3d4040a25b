import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { LineReader } from '../text/line-reader.ts';
import { readInteger } from '../text/read-number.ts';
import { resolveIndex } from './resolve-index.ts';
import type { ObjStreams, TupleStream } from './tuple-stream.ts';
import { vertexLines } from './vertex-lines.ts';

const slash = 0x2f;
const plus = 0x2b;

/** Stands for a texture coordinate or normal that a corner does not have. */
const absent = Infinity;

/** Reads the corners of faces: `v`, `v/vt`, `v//vn` or `v/vt/vn`; nothing is allocated for one. */
export class CornerReader {
  /** The zero-based index of the last corner's point. */
  point = 0;
  /** Its texture coordinate; -1 if it has none. */
  uv = -1;
  /** Its normal; -1 if it has none. */
  normal = -1;
  private readonly reader: LineReader;
  private readonly streams: ObjStreams;
  private readonly log: DiagnosticLog;
  private readonly missingReported = new Set<string>();
  private openCount = 0;
  private laterLines: Uint32Array | undefined;
  /** The numbers between the slashes as they stand in the file. */
  private readonly numbers = new Float64Array(3);

  constructor(reader: LineReader, streams: ObjStreams, log: DiagnosticLog) {
    this.reader = reader;
    this.streams = streams;
    this.log = log;
  }

  /** Reads the current token. Returns false if it is not a corner or if its vertex does not exist. */
  read(): boolean {
    const { numbers, streams } = this;
    if (!this.split()) return false;
    this.point = resolveIndex(numbers[0]!, streams.positions.count);
    if (this.point === -1) return false;
    this.uv = this.optional(numbers[1]!, streams.uvs, 'texture coordinate');
    this.normal = this.optional(numbers[2]!, streams.normals, 'normal');
    return true;
  }

  /** Reports what is wrong with the current token, of which `read` returned false. */
  reportFault(): void {
    if (!this.split()) {
      this.fail('face', 'a corner "v", "v/vt", "v//vn" or "v/vt/vn"', this.reader.text());
      return;
    }
    const index = this.numbers[0]!;
    const { count } = this.streams.positions;
    const range = count > 0 ? `1 to ${count} or -${count} to -1` : 'a vertex, but none came before';
    this.fail('index', range + this.laterPlace(index), `${index}`);
  }

  /**
   * Whether the current token is only a slash, which belongs to the corner before it. It is counted
   * as such.
   */
  isLoneSlash(): boolean {
    const { bytes, tokenStart, tokenEnd } = this.reader;
    const isSlash = tokenEnd - tokenStart === 1 && bytes[tokenStart] === slash;
    if (isSlash) this.openCount++;
    return isSlash;
  }

  /** Reports how many corners ended in a slash. */
  reportOddities(): void {
    if (this.openCount === 0) return;
    this.log.warn({
      code: 'obj/face',
      expected: 'corners that end in a number',
      found: `${this.openCount} that end in a slash`,
      effect: 'they go without what would follow the slash',
    });
  }

  /** Fills `numbers` from the current token; returns false if the token is not a corner. */
  private split(): boolean {
    const { numbers } = this;
    const { bytes, tokenStart, tokenEnd } = this.reader;
    numbers.fill(absent);
    let field = 0;
    let start = tokenStart;
    for (let at = tokenStart; at <= tokenEnd; at++) {
      if (at < tokenEnd && bytes[at] !== slash) continue;
      const number = this.index(start, at);
      if (Number.isNaN(number)) return false;
      if (field === 3) {
        // A slash behind all three numbers is left out, as one behind two is.
        if (number !== absent || at < tokenEnd) return false;
        this.openCount++;
        return true;
      }
      numbers[field++] = number;
      start = at + 1;
    }
    if (numbers[0] === absent) return false;
    if (numbers[field - 1] === absent) this.openCount++;
    return true;
  }

  private index(start: number, end: number): number {
    const { bytes, limits } = this.reader;
    if (start === end) return absent;
    return bytes[start] === plus ? NaN : readInteger(bytes, start, end, limits.tokenLength);
  }

  /** Where a vertex is defined that a face uses before its definition. */
  private laterPlace(index: number): string {
    if (index <= 0) return '';
    this.laterLines ??= vertexLines(this.reader.bytes, this.reader.limits);
    const line = this.laterLines[index - 1];
    return line === undefined ? '' : `; vertex ${index} comes later, in line ${line}`;
  }

  /** A missing texture coordinate or normal is ignored, and the face is kept. */
  private optional(index: number, stream: TupleStream, what: string): number {
    if (index === absent) return -1;
    const { count } = stream;
    const resolved = resolveIndex(index, count);
    if (resolved !== -1 && !stream.isSound(resolved)) return -1; // already reported at its own line
    if (resolved === -1 && !this.missingReported.has(what)) {
      this.missingReported.add(what);
      this.log.warn({
        code: 'obj/index',
        ...this.reader.place,
        expected:
          count > 0 ? `1 to ${count} or -${count} to -1` : `no ${what}, as none came before`,
        found: `${index}`,
        effect: `corners whose ${what} is not there go without`,
      });
    }
    return resolved;
  }

  private fail(kind: 'face' | 'index', expected: string, found: string): void {
    const effect = 'the mesh is not used';
    this.log.error({ code: `obj/${kind}`, ...this.reader.place, expected, found, effect });
  }
}
