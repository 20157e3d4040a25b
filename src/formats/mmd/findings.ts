import type { DiagnosticCode, DiagnosticLog } from '../../core/diagnostics.ts';

/**
 * Collects a problem that many records may have, and reports it in one warning at the first of
 * them.
 */
export class Findings {
  private count = 0;
  private first: { readonly offset: number; readonly found: string } | undefined;

  add(offset: number, found: string): void {
    this.first ??= { offset, found };
    this.count++;
  }

  /** Reports the problem, if it occurred. */
  warn(log: DiagnosticLog, code: DiagnosticCode, expected: string, effect: string): void {
    if (!this.first) return;
    const more = this.count > 1 ? ` and ${this.count - 1} more` : '';
    const { offset, found } = this.first;
    log.warn({ code, offset, expected, found: `${found}${more}`, effect });
  }
}
