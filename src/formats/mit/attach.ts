import type { SkinParts } from '../../core/character-parts.ts';
import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { checkFloat32 } from '../text/check-float32.ts';
import { growFloat32, growUint16, growUint32 } from '../text/growable.ts';
import type { LineReader } from '../text/line-reader.ts';
import { PlainNumbers } from '../text/plain-numbers.ts';
import { openText } from '../text/open-text.ts';

const effect = 'the mesh is shown without its weights';

/** The expected number of columns and its reason: one per joint except the root. */
export interface ExpectedColumns {
  readonly count: number;
  /** "18 joints in a.skel, less the root" */
  readonly reason: string;
}

/**
 * Reads a 6.837 `.attach` (handout, 4.3) into sparse rows: a line per vertex, column i the weight
 * of joint i + 1 (joint 0 has none). Zeros are left out. Blank lines may occur only at the end. If
 * the skeleton is known, the first row must match it; otherwise the first row sets the length of
 * all rows. With only one joint there is no column, so all rows are blank.
 */
export function readAttach(
  file: string,
  bytes: Uint8Array,
  skeletonColumns?: ExpectedColumns,
  limits: Limits = defaultLimits,
): Parsed<SkinParts> {
  const log = new DiagnosticLog(file);
  const reader = openText(file, bytes, log, { limits });
  if (!reader) return log.finish<SkinParts>(undefined);
  const rows = new RowReader(reader, log);
  let columns = skeletonColumns;
  let blankLine: number | undefined;
  for (;;) {
    if (columns && blankLine === undefined) rows.readPlain(columns.count);
    if (!reader.next() || !rows.hasRoom()) break;
    if (reader.isComment()) continue;
    const columnCount = reader.countTokens();
    if (columnCount === 0 && columns?.count !== 0) {
      blankLine ??= reader.line;
      continue;
    }
    if (blankLine !== undefined) reportBlank(blankLine, log);
    blankLine = undefined;
    columns ??= { count: columnCount, reason: 'as in the first row' };
    if (columnCount !== columns.count) {
      reportColumns(reader, columnCount, columns, log);
      if (rows.count === 0) break; // of another skeleton, like all further rows
    }
    if (!rows.read()) break;
  }
  if (rows.count === 0 && !log.failed) {
    log.error({ code: 'attach/empty', expected: 'a row a vertex', found: 'no row', effect });
  }
  return log.finish({ file, ...rows.finish() });
}

/** Collects rows of weights. */
class RowReader {
  private readonly start = growUint32();
  private readonly joints = growUint16();
  private readonly weights = growFloat32();
  private readonly lines = growUint32();
  private readonly reader: LineReader;
  private readonly log: DiagnosticLog;
  private readonly numbers: PlainNumbers;

  constructor(reader: LineReader, log: DiagnosticLog) {
    this.numbers = new PlainNumbers(reader.bytes, reader.limits, false);
    this.reader = reader;
    this.log = log;
    this.start.push(0);
  }

  get count(): number {
    return this.start.length - 1;
  }

  finish(): Omit<SkinParts, 'file'> {
    const { start, lines, joints, weights } = this;
    return {
      start: start.finish(),
      lines: lines.finish(),
      joints: joints.finish(),
      weights: weights.finish(),
    };
  }

  /** Returns false, with an error, if another row would be too many. */
  hasRoom(): boolean {
    const { pointCount } = this.reader.limits;
    return this.count < pointCount || this.exceeds(`at most ${pointCount} rows`);
  }

  /**
   * Reads rows of exactly so many plain weights within all limits, which are nearly all rows of most
   * files. Stops before the first other line, which is left to the careful reader.
   */
  readPlain(columnCount: number): void {
    const { reader, numbers, lines } = this;
    const { jointCount, pointCount } = reader.limits;
    if (columnCount === 0 || columnCount >= jointCount) return;
    const values = new Float64Array(columnCount);
    let { nextStart: lineStart, nextLine: line } = reader;
    while (lineStart < numbers.end && this.count < pointCount) {
      numbers.at = lineStart;
      if (numbers.numbers(values, columnCount) < columnCount) break;
      if (!numbers.endLine(lineStart) || !this.addRow(values)) break;
      lines.push(line++);
      lineStart = numbers.at;
    }
    reader.nextStart = lineStart;
    reader.nextLine = line;
  }

  /** Adds a row without its zeros; returns false, without effect, if a weight is too large. */
  private addRow(row: Float64Array): boolean {
    const largest = this.reader.limits.weight;
    const joints = this.joints.reserve(row.length);
    const weights = this.weights.reserve(row.length);
    let next = this.weights.length;
    for (let column = 0; column < row.length; column++) {
      const weight = row[column]!;
      if (weight === 0) continue;
      if (!(weight <= largest && weight >= -largest)) return false;
      joints[next] = column + 1;
      weights[next++] = weight;
    }
    this.joints.length = next;
    this.weights.length = next;
    this.start.push(next);
    return true;
  }

  /**
   * Reads the current line; returns false, with an error, if it has more columns than the limit on
   * joints.
   */
  read(): boolean {
    const { jointCount, weight: largest } = this.reader.limits;
    for (let column = 1; this.reader.token(); column++) {
      if (column >= jointCount) return this.exceeds(`at most ${jointCount - 1} weights in a row`);
      let weight = this.reader.number();
      if (weight === 0) continue;
      if (!(Math.abs(weight) <= largest)) {
        const field = { what: `weight ${column}`, area: 'attach', effect, largest } as const;
        weight = checkFloat32(this.reader, field, this.log);
      }
      this.joints.push(column);
      this.weights.push(weight);
    }
    this.start.push(this.weights.length);
    this.lines.push(this.reader.line);
    return true;
  }

  private exceeds(expected: string): false {
    this.log.error({
      code: 'attach/limit',
      ...this.reader.linePlace,
      expected,
      found: 'more',
      effect,
    });
    return false;
  }
}

function reportBlank(line: number, log: DiagnosticLog): void {
  const expected = 'a row of weights for every vertex';
  log.error({ code: 'attach/count', line, expected, found: 'a blank line', effect });
}

function reportColumns(
  reader: LineReader,
  found: number,
  { count, reason }: ExpectedColumns,
  log: DiagnosticLog,
): void {
  log.error({
    code: 'attach/field-count',
    ...reader.linePlace,
    expected: `${count} weights (${reason})`,
    found: `${found}`,
    effect,
  });
}
