import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { growInt32, growUint32 } from '../text/growable.ts';
import type { LineReader } from '../text/line-reader.ts';
import { CornerReader } from './corner-reader.ts';
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
    const { corners, points } = this;
    const before = points.length;
    let isSound = true;
    let count = 0;
    while (this.reader.token()) {
      if (++count > cornersPerFace) continue; // only count further corners
      if (!corners.read()) {
        this.goBack(before);
        return;
      }
      // A vertex that is not numbers was already reported at its own line.
      isSound &&= this.streams.positions.isSound(corners.point);
      points.push(corners.point);
      this.uvs.push(corners.uv);
      this.normals.push(corners.normal);
    }
    if (count < 3) this.shortCount++;
    else if (count > cornersPerFace) {
      this.fail('limit', `a face of at most ${cornersPerFace} corners`, `${count}`);
    } else if (points.length - 2 * (this.faceCount + 1) > triangleCount) {
      this.full = true;
      this.fail('limit', `at most ${triangleCount} triangles`, 'more');
    } else if (isSound) {
      this.ends.push(points.length);
      return;
    }
    this.goBack(before);
  }

  /** Forgets the corners from this one on. */
  private goBack(cornerCount: number): void {
    for (const values of [this.points, this.uvs, this.normals]) values.length = cornerCount;
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

  private fail(kind: 'face' | 'limit', expected: string, found: string): void {
    this.log.error({ code: `obj/${kind}`, ...this.reader.place, expected, found, effect });
  }
}
