import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { LineReader } from '../text/line-reader.ts';
import { CornerReader } from './corner-reader.ts';
import type { FaceList } from './face-list.ts';
import type { ObjStreams } from './tuple-stream.ts';

const effect = 'the mesh is not used';

/** Reads `f` lines, `f a b c …` with three corners or more, and reports what is wrong with them. */
export class FaceReader {
  private shortCount = 0;
  private readonly reader: LineReader;
  private readonly streams: ObjStreams;
  private readonly faces: FaceList;
  private readonly log: DiagnosticLog;
  private readonly corners: CornerReader;
  private full = false;

  constructor(reader: LineReader, streams: ObjStreams, faces: FaceList, log: DiagnosticLog) {
    this.reader = reader;
    this.streams = streams;
    this.faces = faces;
    this.log = log;
    this.corners = new CornerReader(reader, streams, log);
  }

  /** Whether a face exceeded the limit, which has been reported. */
  get isFull(): boolean {
    return this.full;
  }

  /** Reads the rest of the current line. */
  read(): void {
    const { reader, faces, corners } = this;
    const { cornersPerFace, triangleCount } = reader.limits;
    let isSound = true;
    let count = 0;
    while (reader.token()) {
      if (count > 0 && corners.isLoneSlash()) continue;
      if (++count > cornersPerFace) continue; // only count further corners
      if (!corners.read()) {
        this.refuse(count);
        return;
      }
      // A vertex that is not numbers was already reported at its own line.
      isSound &&= this.streams.positions.isSound(corners.point);
      faces.addCorner(corners.point, corners.uv, corners.normal);
    }
    if (count < 3) this.shortCount++;
    else if (count > cornersPerFace) {
      this.fail(`a face of at most ${cornersPerFace} corners`, `${count}`);
    } else if (isSound && !faces.closeFace()) {
      this.full = true;
      this.fail(`at most ${triangleCount} triangles`, 'more');
    }
    faces.dropCorners();
  }

  /** A face of too few corners is left out, whatever they are; of others the wrong one is reported. */
  private refuse(count: number): void {
    const { reader, faces, corners } = this;
    const { tokenStart, tokenEnd } = reader;
    let all = count;
    while (all < 3 && reader.token()) if (!corners.isLoneSlash()) all++;
    reader.tokenStart = tokenStart;
    reader.tokenEnd = tokenEnd;
    if (all < 3) this.shortCount++;
    else corners.reportFault();
    faces.dropCorners();
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

  private fail(expected: string, found: string): void {
    this.log.error({ code: 'obj/limit', ...this.reader.place, expected, found, effect });
  }
}
