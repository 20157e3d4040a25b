import type { DiagnosticCode, DiagnosticLog } from '../../core/diagnostics.ts';
import { BinaryRecord } from './binary-record.ts';

/** The diagnostic codes of a format for the problems that the reader finds. */
export interface BinaryCodes {
  readonly truncated: DiagnosticCode;
  readonly count: DiagnosticCode;
}

/**
 * Reads a binary file from start to end, by records or arrays of records. Sizes are compared with
 * the remaining bytes before anything is taken, so that no count in a file can cause a large
 * allocation. If data is missing, that is reported and nothing is returned.
 */
export class BinaryReader {
  private position = 0;
  private lenientEffect: string | undefined;
  private readonly file: Uint8Array;
  private readonly log: DiagnosticLog;
  private readonly codes: BinaryCodes;
  private readonly effect: string;

  constructor(file: Uint8Array, log: DiagnosticLog, codes: BinaryCodes, effect: string) {
    this.file = file;
    this.log = log;
    this.codes = codes;
    this.effect = effect;
  }

  /** The number of bytes before the next one to be read. */
  get offset(): number {
    return this.position;
  }

  /** The number of bytes that have not been read. */
  get left(): number {
    return this.file.length - this.position;
  }

  /**
   * From here on missing data is a warning with this effect, because the file is usable without it.
   */
  beLenient(effect: string): void {
    this.lenientEffect = effect;
  }

  /** Returns the next `size` bytes; `what` names them in messages. */
  record(size: number, what: string): BinaryRecord | undefined {
    if (size > this.left) {
      const bytes = (count: number): string => (count === 1 ? '1 byte' : `${count} bytes`);
      const expected = `${bytes(size)} for ${what}`;
      this.report(this.codes.truncated, this.position, expected, bytes(this.left));
      return undefined;
    }
    const record = new BinaryRecord(this.file, this.position, size);
    this.position += size;
    return record;
  }

  /** Reads a whole number of 1, 2 or 4 bytes, such as a count. */
  integer(size: 1 | 2 | 4, what: string): number | undefined {
    const record = this.record(size, what);
    if (!record) return undefined;
    return size === 1 ? record.u8(0) : size === 2 ? record.u16(0) : record.u32(0);
  }

  /** Reads a count and that number of records of `size` bytes, as one record over all of them. */
  array(countSize: 1 | 2 | 4, size: number, what: string): RecordArray | undefined {
    const start = this.position;
    const count = this.integer(countSize, `the number of ${what}`);
    if (count === undefined || !this.fits(count, size, what, start)) return undefined;
    return { count, offset: start, records: this.record(count * size, what)! };
  }

  /**
   * Whether `count` records of at least `size` bytes can still follow; reports it if not.
   *
   * @param countOffset where the file has the count
   */
  fits(count: number, size: number, what: string, countOffset: number): boolean {
    // Exact, because a count is less than 2^32 and products of doubles below 2^53 are exact.
    if (count * size <= this.left) return true;
    const most = Math.floor(this.left / size);
    const expected = `at most ${most} ${what} of ${size} bytes in the ${this.left} bytes left`;
    this.report(this.codes.count, countOffset, expected, `${count}`);
    return false;
  }

  private report(code: DiagnosticCode, offset: number, expected: string, found: string): void {
    const { lenientEffect, effect } = this;
    if (lenientEffect === undefined) this.log.error({ code, offset, expected, found, effect });
    else this.log.warn({ code, offset, expected, found, effect: lenientEffect });
  }
}

export interface RecordArray {
  readonly count: number;
  /** Where the file has the count. */
  readonly offset: number;
  readonly records: BinaryRecord;
}
