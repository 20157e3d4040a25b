import type { MeshParts } from '../../core/character-parts.ts';
import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { Limits } from '../../core/limits.ts';
import { growInt32, growUint32, type Growable } from '../text/growable.ts';
import type { LineReader } from '../text/line-reader.ts';
import { readInteger } from '../text/read-number.ts';
import { triangulate } from './triangulate.ts';

const effect = 'the mesh is not used';
const slash = 0x2f;

interface Streams {
  readonly positions: Growable<Float32Array>;
  readonly uvs: Growable<Float32Array>;
  readonly normals: Growable<Float32Array>;
}

/** Corners as zero-based indices; -1 where a corner has no texture coordinate or normal. */
interface Face {
  readonly points: number[];
  readonly uvs: number[];
  readonly normals: number[];
}

/** Reads the `f` lines of an OBJ: `f a b c …`, each corner `v`, `v/vt`, `v//vn` or `v/vt/vn`. */
export class FaceReader {
  degenerateCount = 0;
  private readonly cornerPoints = growUint32();
  private readonly cornerUvs = growInt32();
  private readonly cornerNormals = growInt32();
  private readonly reader: LineReader;
  private readonly streams: Streams;
  private readonly limits: Limits;
  private readonly log: DiagnosticLog;
  private missingUvReported = false;

  constructor(reader: LineReader, streams: Streams, limits: Limits, log: DiagnosticLog) {
    this.reader = reader;
    this.streams = streams;
    this.limits = limits;
    this.log = log;
  }

  get triangleCount(): number {
    return this.cornerPoints.length / 3;
  }

  finish(): Pick<MeshParts, 'cornerPoints' | 'cornerUvs' | 'cornerNormals'> {
    return {
      cornerPoints: this.cornerPoints.finish(),
      cornerUvs: this.cornerUvs.finish(),
      cornerNormals: this.cornerNormals.finish(),
    };
  }

  /** Reads the rest of the current line. */
  read(): void {
    const face: Face = { points: [], uvs: [], normals: [] };
    while (this.reader.token()) if (!this.readCorner(face)) return;
    if (face.points.length < 3) {
      this.fail('face', 'a face of at least 3 corners', `${face.points.length}`);
    } else if (face.points.length > this.limits.cornersPerFace) {
      const expected = `a face of at most ${this.limits.cornersPerFace} corners`;
      this.fail('limit', expected, `${face.points.length}`);
    } else if (this.triangleCount + face.points.length - 2 > this.limits.triangleCount) {
      this.fail('limit', `at most ${this.limits.triangleCount} triangles`, 'more');
    } else this.addTriangles(face);
  }

  private addTriangles(face: Face): void {
    const { positions } = this.streams;
    const local = face.points.flatMap((point) => [0, 1, 2].map((i) => positions.at(point * 3 + i)));
    const order = triangulate(
      local,
      face.points.map((_, corner) => corner),
    );
    for (let i = 0; i < order.length; i += 3) {
      const corners = [order[i]!, order[i + 1]!, order[i + 2]!];
      if (new Set(corners.map((corner) => face.points[corner])).size < 3) {
        this.degenerateCount++;
        continue;
      }
      for (const corner of corners) {
        this.cornerPoints.push(face.points[corner]!);
        this.cornerUvs.push(face.uvs[corner]!);
        this.cornerNormals.push(face.normals[corner]!);
      }
    }
  }

  private readCorner(face: Face): boolean {
    const { bytes, tokenStart, tokenEnd } = this.reader;
    const cuts = [tokenStart - 1];
    for (let at = tokenStart; at < tokenEnd; at++) if (bytes[at] === slash) cuts.push(at);
    cuts.push(tokenEnd);
    const part = (index: number): number | undefined => {
      const start = (cuts[index] ?? tokenEnd) + 1;
      const end = cuts[index + 1] ?? start;
      return end > start ? readInteger(bytes, start, end) : undefined;
    };
    const [point, uv, normal] = [part(0), part(1), part(2)];
    const trailingSlash = bytes[tokenEnd - 1] === slash;
    const wellFormed = [point, uv, normal].every((index) => !Number.isNaN(index));
    if (point === undefined || !wellFormed || cuts.length > 4 || trailingSlash) {
      this.fail('face', 'a corner "v", "v/vt", "v//vn" or "v/vt/vn"', this.reader.text());
      return false;
    }
    const pointIndex = this.resolve(point, this.streams.positions.length / 3);
    if (pointIndex === undefined) return false;
    face.points.push(pointIndex);
    face.uvs.push(this.resolveOptional(uv, this.streams.uvs.length / 2));
    face.normals.push(this.resolveOptional(normal, this.streams.normals.length / 3));
    return true;
  }

  /** One-based, or negative and counted back from this line, to zero-based. */
  private resolve(index: number, count: number): number | undefined {
    const resolved = index < 0 ? count + index : index - 1;
    if (index !== 0 && resolved >= 0 && resolved < count) return resolved;
    this.fail('index', `1 to ${count} or -${count} to -1`, `${index}`);
    return undefined;
  }

  /** A texture coordinate or normal that is not there costs only itself, not the face. */
  private resolveOptional(index: number | undefined, count: number): number {
    if (index === undefined) return -1;
    const resolved = index < 0 ? count + index : index - 1;
    if (index !== 0 && resolved >= 0 && resolved < count) return resolved;
    if (!this.missingUvReported) {
      this.missingUvReported = true;
      this.log.warn({
        code: 'obj/index',
        ...this.reader.place,
        expected: count > 0 ? `1 to ${count} or -${count} to -1` : 'none, as the file has none',
        found: `${index}`,
        effect: 'such corners go without texture coordinate or normal',
      });
    }
    return -1;
  }

  private fail(kind: 'face' | 'index' | 'limit', expected: string, found: string): void {
    this.log.error({ code: `obj/${kind}`, ...this.reader.place, expected, found, effect });
  }
}
