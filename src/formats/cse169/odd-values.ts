import type { Place } from '../../core/diagnostics.ts';
import type { Scanner } from './scanner.ts';

/** What programs write for a value that they do not have, and numbers past what is computed with. */
const isOdd = /^[+-]?(nan|inf|undefined|null|none|[\d.])/i;

/** Values of a section that are not numbers, where the character can be shown without them. */
export class OddValues {
  private count = 0;
  private first: Place | undefined;

  /** Whether the current token is such a value, which is counted. */
  take(scanner: Scanner): boolean {
    const { reader, limits } = scanner;
    const isNumber = Math.abs(reader.number(limits.tokenLength)) <= limits.coordinate;
    if (isNumber || !isOdd.test(reader.text())) return false;
    this.count++;
    this.first ??= reader.place;
    return true;
  }

  /** Reports them, and returns whether there are any. */
  report({ log }: Scanner, name: string): boolean {
    if (!this.first) return false;
    log.warn({
      code: 'skin/number',
      ...this.first,
      expected: `${name} that are numbers`,
      found: `${this.count} that are not`,
      effect: 'they are not used',
    });
    return true;
  }
}
