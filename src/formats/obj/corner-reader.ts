import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { LineReader } from '../text/line-reader.ts';
import { readInteger } from '../text/read-number.ts';
import type { ObjStreams, TupleStream } from './tuple-stream.ts';
import { vertexLines } from './vertex-lines.ts';

const slash = 0x2f;
const plus = 0x2b;

/** Zero-based indices; -1 where a corner has no texture coordinate or normal. */
export interface Corner {
  readonly point: number;
  readonly uv: number;
  readonly normal: number;
}

/** Reads the corners of faces: `v`, `v/vt`, `v//vn` or `v/vt/vn`. */
export class CornerReader {
  private readonly reader: LineReader;
  private readonly streams: ObjStreams;
  private readonly log: DiagnosticLog;
  private readonly missingReported = new Set<string>();
  private openCount = 0;
  private laterLines: Uint32Array | undefined;

  constructor(reader: LineReader, streams: ObjStreams, log: DiagnosticLog) {
    this.reader = reader;
    this.streams = streams;
    this.log = log;
  }

  /** The current token; nothing, and an error, where it is no corner of a vertex that is there. */
  read(): Corner | undefined {
    const parts = this.parts();
    if (!parts) {
      this.fail('face', 'a corner "v", "v/vt", "v//vn" or "v/vt/vn"', this.reader.text());
      return undefined;
    }
    const count = this.streams.positions.count;
    const point = resolve(parts.point, count);
    if (point === -1) {
      const range =
        count > 0 ? `1 to ${count} or -${count} to -1` : 'a vertex, but none came before';
      this.fail('index', range + this.laterPlace(parts.point), `${parts.point}`);
      return undefined;
    }
    return {
      point,
      uv: this.optional(parts.uv, this.streams.uvs, 'texture coordinate'),
      normal: this.optional(parts.normal, this.streams.normals, 'normal'),
    };
  }

  /** Says how many corners ended in a slash. */
  reportOddities(): void {
    if (this.openCount === 0) return;
    this.log.warn({
      code: 'obj/face',
      expected: 'corners that end in a number',
      found: `${this.openCount} that end in a slash`,
      effect: 'they go without what would follow the slash',
    });
  }

  /** The numbers between the slashes as they stand; nothing where the token is no corner. */
  private parts(): { point: number; uv?: number; normal?: number } | undefined {
    const { bytes, tokenStart, tokenEnd } = this.reader;
    const numbers: (number | undefined)[] = [];
    let start = tokenStart;
    for (let at = tokenStart; at <= tokenEnd; at++) {
      if (at < tokenEnd && bytes[at] !== slash) continue;
      if (numbers.length === 3 && (start < at || at < tokenEnd)) return undefined;
      numbers.push(this.index(start, at));
      start = at + 1;
    }
    const [point, uv, normal] = numbers;
    if (point === undefined || numbers.some(Number.isNaN)) return undefined;
    if (numbers.at(-1) === undefined) this.openCount++;
    return {
      point,
      ...(uv === undefined ? {} : { uv }),
      ...(normal === undefined ? {} : { normal }),
    };
  }

  private index(start: number, end: number): number | undefined {
    const { bytes, limits } = this.reader;
    if (start === end) return undefined;
    return bytes[start] === plus ? NaN : readInteger(bytes, start, end, limits.tokenLength);
  }

  /** Where a vertex comes that faces refer to before it. */
  private laterPlace(index: number): string {
    if (index <= 0) return '';
    this.laterLines ??= vertexLines(this.reader.bytes, this.reader.limits);
    const line = this.laterLines[index - 1];
    return line === undefined ? '' : `; vertex ${index} comes later, in line ${line}`;
  }

  /** A texture coordinate or normal that is not there costs only itself, not the face. */
  private optional(index: number | undefined, stream: TupleStream, what: string): number {
    if (index === undefined) return -1;
    const { count } = stream;
    const resolved = resolve(index, count);
    if (resolved !== -1 && !stream.isSound(resolved)) return -1; // which its own line has said
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

/** One-based, or negative and counted back from this line, to zero-based; -1 where it is not there. */
function resolve(index: number, count: number): number {
  const resolved = index < 0 ? count + index : index - 1;
  return index !== 0 && resolved >= 0 && resolved < count ? resolved : -1;
}
