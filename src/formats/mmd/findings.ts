import type { DiagnosticCode, DiagnosticLog } from '../../core/diagnostics.ts';

/**
 * Collects a problem that many records may have, and reports it in one warning at the first of
 * them.
 */
export class Findings {
  private count = 0;
  private first: { readonly at: number; readonly found: string } | undefined;
  private readonly by: 'offset' | 'line';

  /** @param by whether its places are offsets in bytes or lines */
  constructor(by: 'offset' | 'line' = 'offset') {
    this.by = by;
  }

  add(at: number, found: string): void {
    this.first ??= { at, found };
    this.count++;
  }

  /** Reports the problem, if it occurred. */
  warn(log: DiagnosticLog, code: DiagnosticCode, expected: string, effect: string): void {
    if (!this.first) return;
    const more = this.count > 1 ? ` and ${this.count - 1} more` : '';
    const { at, found } = this.first;
    log.warn({ code, [this.by]: at, expected, found: `${found}${more}`, effect });
  }
}
