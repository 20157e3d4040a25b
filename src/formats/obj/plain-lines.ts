import type { LineReader } from '../text/line-reader.ts';
import { isBlank } from '../text/line-ends.ts';
import { PlainNumbers } from '../text/plain-numbers.ts';
import type { FaceList } from './face-list.ts';
import { PlainCorners } from './plain-corners.ts';
import type { ObjStreams, TupleStream } from './tuple-stream.ts';

const letterF = 0x66;
const letterN = 0x6e;
const letterT = 0x74;
const letterV = 0x76;

/** Coordinates with w or a color have up to seven numbers. */
const mostNumbers = 8;

/**
 * Reads the plain lines of an OBJ, which are nearly all lines of most files: `v`, `vt`, `vn` and `f`
 * with plain numbers within all limits. Every other line, and every line that gives a message, is
 * left to the careful readers.
 */
export class PlainLines {
  private readonly numbers: PlainNumbers;
  private readonly values = new Float64Array(mostNumbers);
  private readonly corners = new PlainCorners();
  private readonly reader: LineReader;
  private readonly streams: ObjStreams;
  private readonly faces: FaceList;

  constructor(reader: LineReader, streams: ObjStreams, faces: FaceList) {
    this.numbers = new PlainNumbers(reader.bytes, reader.limits, false);
    this.reader = reader;
    this.streams = streams;
    this.faces = faces;
  }

  /** Reads all plain lines from the next one on, and leaves the careful reader behind them. */
  read(): void {
    const { numbers, reader } = this;
    let lineStart = reader.nextStart;
    let line = reader.nextLine;
    while (lineStart < numbers.end && this.readLine(lineStart)) {
      lineStart = numbers.at;
      line++;
    }
    reader.nextStart = lineStart;
    reader.nextLine = line;
  }

  /** Returns false, without effect, if the line is not plain. */
  private readLine(lineStart: number): boolean {
    const { numbers } = this;
    numbers.at = lineStart;
    const letter = numbers.skipBlanks();
    const second = numbers.bytes[++numbers.at]!;
    if (letter === letterF) {
      return isBlank(second) && this.readFace(lineStart);
    }
    if (letter !== letterV) return false;
    if (isBlank(second)) return this.readTuple(this.streams.positions, lineStart);
    numbers.at++;
    if (second === letterT) return this.readTuple(this.streams.uvs, lineStart);
    return second === letterN && this.readTuple(this.streams.normals, lineStart);
  }

  private readFace(lineStart: number): boolean {
    const { numbers, corners, streams, faces } = this;
    const { cornersPerFace } = numbers.limits;
    const { positions, uvs, normals } = streams;
    // A face that refers to a tuple without numbers is not plain.
    if (!positions.isAllSound || !uvs.isAllSound || !normals.isAllSound) return false;
    const lineEnd = corners.read(numbers.bytes, numbers.at);
    if (lineEnd === -1 || corners.count < 3 || corners.count > cornersPerFace) return false;
    numbers.at = lineEnd;
    if (numbers.endLine(lineStart) && faces.addFace(corners, streams)) return true;
    faces.dropCorners();
    return false;
  }

  private readTuple(stream: TupleStream, lineStart: number): boolean {
    const { numbers, values } = this;
    if (!isBlank(numbers.bytes[numbers.at]!)) return false;
    const count = numbers.numbers(values, mostNumbers);
    return numbers.endLine(lineStart) && stream.add(values, count);
  }
}
