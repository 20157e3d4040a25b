import type { MeshParts } from '../../core/character-parts.ts';
import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { growInt32, growUint32 } from '../text/growable.ts';
import type { LineReader } from '../text/line-reader.ts';
import { type Corner, CornerReader } from './corner-reader.ts';
import { triangulate } from './triangulate.ts';
import type { ObjStreams } from './tuple-stream.ts';

const effect = 'the mesh is not used';

/** Reads the `f` lines of an OBJ: `f a b c …`, three corners or more. */
export class FaceReader {
  private degenerateCount = 0;
  private shortCount = 0;
  private readonly cornerPoints = growUint32();
  private readonly cornerUvs = growInt32();
  private readonly cornerNormals = growInt32();
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

  get triangleCount(): number {
    return this.cornerPoints.length / 3;
  }

  /** Whether a face was one too many, which was said. */
  get isFull(): boolean {
    return this.full;
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
    const { cornersPerFace, triangleCount } = this.reader.limits;
    const face: Corner[] = [];
    let count = 0;
    while (this.reader.token()) {
      if (++count > cornersPerFace) continue; // only counted
      const corner = this.corners.read();
      if (!corner) return;
      face.push(corner);
    }
    if (count < 3) this.shortCount++;
    else if (count > cornersPerFace) {
      this.fail('limit', `a face of at most ${cornersPerFace} corners`, `${count}`);
    } else if (this.triangleCount + count - 2 > triangleCount) {
      this.full = true;
      this.fail('limit', `at most ${triangleCount} triangles`, 'more');
    } else this.addTriangles(face);
  }

  /** Says what harmless things were met, each kind once with its count. */
  reportOddities(): void {
    const effect = 'they are left out';
    if (this.degenerateCount > 0) {
      const expected = 'triangles of three different vertices';
      const found = `${this.degenerateCount} that are not`;
      this.log.warn({ code: 'obj/degenerate', expected, found, effect });
    }
    if (this.shortCount > 0) {
      const expected = 'faces of at least 3 corners';
      const found = `${this.shortCount} of fewer`;
      this.log.warn({ code: 'obj/face', expected, found, effect });
    }
    this.corners.reportOddities();
  }

  private addTriangles(face: readonly Corner[]): void {
    const { positions } = this.streams;
    if (!face.every(({ point }) => positions.isSound(point))) return; // which the vertex's line has said
    const local = face.flatMap(({ point }) => [0, 1, 2].map((i) => positions.value(point * 3 + i)));
    const order = triangulate(
      local,
      face.map((_, corner) => corner),
    );
    for (let i = 0; i < order.length; i += 3) {
      const corners = [order[i]!, order[i + 1]!, order[i + 2]!].map((corner) => face[corner]!);
      if (new Set(corners.map(({ point }) => point)).size < 3) {
        this.degenerateCount++;
        continue;
      }
      for (const { point, uv, normal } of corners) {
        this.cornerPoints.push(point);
        this.cornerUvs.push(uv);
        this.cornerNormals.push(normal);
      }
    }
  }

  private fail(kind: 'face' | 'limit', expected: string, found: string): void {
    this.log.error({ code: `obj/${kind}`, ...this.reader.place, expected, found, effect });
  }
}
