import type { DiagnosticCode, DiagnosticLog } from '../../core/diagnostics.ts';
import { defaultLimits } from '../../core/limits.ts';
import { boundText } from '../text/bound-text.ts';

/** A line of a text with its number, from 1. */
export interface TextLine {
  readonly line: number;
  readonly text: string;
}

export function textLines(text: string): TextLine[] {
  return text.split(/\r*\n|\r/).map((each, index) => ({ line: index + 1, text: each }));
}

/** A line without its comment, and without blanks around it. */
export function bareText({ text }: TextLine): string {
  const comment = text.indexOf('//');
  return (comment < 0 ? text : text.slice(0, comment)).trim();
}

const numeral = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const longestSource = 160;

/** Reads the lines of numbers in the blocks of a pose. */
export class VpdRows {
  private readonly log: DiagnosticLog;
  private readonly effect: string;

  /** @param effect of an error on its block */
  constructor(log: DiagnosticLog, effect: string) {
    this.log = log;
    this.effect = effect;
  }

  /** Reads `1,2,3;`; nothing, with a report, if the numbers are not as many or not finite. */
  numbers(line: TextLine, count: number, what: string): number[] | undefined {
    const text = bareText(line).replace(/\}.*$/, '').trim();
    const end = text.indexOf(';');
    if (end < 0) this.warn('vpd/token', line, `";" after ${what}`, 'none');
    const words = (end < 0 ? text : text.slice(0, end)).split(',').map((word) => word.trim());
    if (words.length !== count) {
      const s = count === 1 ? '' : 's';
      this.report('vpd/field-count', line, `${count} number${s}, ${what}`, `${words.length}`);
      return undefined;
    }
    const wrong = words.find((word) => !numeral.test(word));
    if (wrong !== undefined) {
      this.report('vpd/number', line, `a number in ${what}`, wrong);
      return undefined;
    }
    const values = words.map(Number);
    const most = defaultLimits.coordinate;
    const far = values.findIndex((value) => Math.abs(value) > most);
    if (far < 0) return values;
    this.report('vpd/range', line, `numbers within ±${boundText(most)} for ${what}`, words[far]!);
    return undefined;
  }

  /** Reports an error, whose block is left out. */
  report(code: DiagnosticCode, line: TextLine, expected: string, found: string): void {
    this.log.errorOfPart({ code, ...placeOf(line), expected, found, effect: this.effect });
  }

  /** Reports something that is read nevertheless. */
  warn(code: DiagnosticCode, line: TextLine, expected: string, found: string): void {
    const effect = 'read as if it were so';
    this.log.warn({ code, ...placeOf(line), expected, found, effect });
  }
}

function placeOf({ line, text }: TextLine): { readonly line: number; readonly source: string } {
  return { line, source: text.slice(0, longestSource) };
}
