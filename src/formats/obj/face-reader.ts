import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { growInt32, growUint32 } from '../text/growable.ts';
import type { LineReader } from '../text/line-reader.ts';
import { type Corner, CornerReader } from './corner-reader.ts';
import { type FaceTriangles, triangulateFaces } from './triangulate-faces.ts';
import type { ObjStreams } from './tuple-stream.ts';

const effect = 'the mesh is not used';

/** Reads the `f` lines of an OBJ: `f a b c …`, three corners or more. */
export class FaceReader {
  private shortCount = 0;
  private readonly points = growUint32();
  private readonly uvs = growInt32();
  private readonly normals = growInt32();
  private readonly ends = growUint32();
  private readonly reader: LineReader;
  private readonly streams: ObjStreams;
  private readonly log: DiagnosticLog;
  private readonly corners: CornerReader;
  private full = false;

  constructor(reader: LineReader, streams: ObjStreams, log: DiagnosticLog) {
    this.reader = reader;
    this.streams = streams;
    this.log = log;
    this.corners = new CornerReader(reader, streams, log);
  }

  get faceCount(): number {
    return this.ends.length;
  }

  /** Whether a face exceeded the limit, which has been reported. */
  get isFull(): boolean {
    return this.full;
  }

  /** Triangulates all faces. @param positions (pointCount × 3) */
  finish(positions: Float32Array): Promise<FaceTriangles> {
    const faces = {
      points: this.points.finish(),
      uvs: this.uvs.finish(),
      normals: this.normals.finish(),
      ends: this.ends.finish(),
    };
    return triangulateFaces(faces, positions);
  }

  /** Reads the rest of the current line. */
  read(): void {
    const { cornersPerFace, triangleCount } = this.reader.limits;
    const face: Corner[] = [];
    let count = 0;
    while (this.reader.token()) {
      if (++count > cornersPerFace) continue; // only count further corners
      const corner = this.corners.read();
      if (!corner) return;
      face.push(corner);
    }
    if (count < 3) this.shortCount++;
    else if (count > cornersPerFace) {
      this.fail('limit', `a face of at most ${cornersPerFace} corners`, `${count}`);
    } else if (this.points.length - 2 * this.faceCount + count - 2 > triangleCount) {
      this.full = true;
      this.fail('limit', `at most ${triangleCount} triangles`, 'more');
    } else this.add(face);
  }

  /** Reports harmless oddities, each kind once with its count. */
  reportOddities(degenerateCount: number): void {
    const effect = 'they are left out';
    if (degenerateCount > 0) {
      const expected = 'triangles of three different vertices';
      const found = `${degenerateCount} that are not`;
      this.log.warn({ code: 'obj/degenerate', expected, found, effect });
    }
    if (this.shortCount > 0) {
      const expected = 'faces of at least 3 corners';
      const found = `${this.shortCount} of fewer`;
      this.log.warn({ code: 'obj/face', expected, found, effect });
    }
    this.corners.reportOddities();
  }

  private add(face: readonly Corner[]): void {
    const { positions } = this.streams;
    if (!face.every(({ point }) => positions.isSound(point))) return; // already reported
    for (const { point, uv, normal } of face) {
      this.points.push(point);
      this.uvs.push(uv);
      this.normals.push(normal);
    }
    this.ends.push(this.points.length);
  }

  private fail(kind: 'face' | 'limit', expected: string, found: string): void {
    this.log.error({ code: `obj/${kind}`, ...this.reader.place, expected, found, effect });
  }
}
