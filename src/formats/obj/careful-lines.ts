import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { LineReader } from '../text/line-reader.ts';
import type { FaceList } from './face-list.ts';
import { FaceReader } from './face-reader.ts';
import { IgnoredKeywords } from './ignored-keywords.ts';
import type { ObjStreams } from './tuple-stream.ts';

/** Reads the lines of an OBJ that are not plain, and reports what is wrong with them. */
export class CarefulLines {
  private readonly reader: LineReader;
  private readonly streams: ObjStreams;
  private readonly log: DiagnosticLog;
  private readonly faces: FaceReader;
  private readonly ignored: IgnoredKeywords;

  constructor(reader: LineReader, streams: ObjStreams, faces: FaceList, log: DiagnosticLog) {
    this.reader = reader;
    this.streams = streams;
    this.log = log;
    this.faces = new FaceReader(reader, streams, faces, log);
    this.ignored = new IgnoredKeywords(reader, log);
  }

  /** Whether a line exceeded a limit, which has been reported. */
  get isFull(): boolean {
    const { positions, uvs, normals } = this.streams;
    return [positions, uvs, normals, this.faces].some(({ isFull }) => isFull);
  }

  /** Reads the rest of the current line, which begins with the keyword. */
  read(keyword: string): void {
    const { reader, streams, log } = this;
    switch (keyword) {
      case 'v':
        streams.positions.read(reader, log);
        break;
      case 'vt':
        streams.uvs.read(reader, log);
        break;
      case 'vn':
        streams.normals.read(reader, log);
        break;
      case 'f':
        this.faces.read();
        break;
      default:
        this.ignored.note(keyword);
    }
  }

  /** Reports harmless oddities, each kind once with its count. */
  reportOddities(degenerateCount: number): void {
    this.faces.reportOddities(degenerateCount);
    this.streams.uvs.reportOddities(this.log);
    this.streams.normals.reportOddities(this.log);
  }
}
