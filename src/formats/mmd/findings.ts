import type { DiagnosticCode, DiagnosticLog } from '../../core/diagnostics.ts';

/** What is wrong with some of many records, told in one warning with the place of the first. */
export class Findings {
  private count = 0;
  private first: { readonly offset: number; readonly found: string } | undefined;

  add(offset: number, found: string): void {
    this.first ??= { offset, found };
    this.count++;
  }

  /** Says so, if there was any. */
  warn(log: DiagnosticLog, code: DiagnosticCode, expected: string, effect: string): void {
    if (!this.first) return;
    const more = this.count > 1 ? ` and ${this.count - 1} more` : '';
    const { offset, found } = this.first;
    log.warn({ code, offset, expected, found: `${found}${more}`, effect });
  }
}
