import { type Diagnostic, formatDiagnostic } from '../../src/core/diagnostics.ts';

/** Diagnostics without their effects, as "error: FILE:LINE:COL: expected …, found "…" [code]". */
export function said(diagnostics: readonly Diagnostic[]): string[] {
  return diagnostics.map((diagnostic) => {
    const { severity, code } = diagnostic;
    return `${severity}: ${formatDiagnostic(diagnostic)} [${code}]`;
  });
}

/** The same with their effects: "…; the file is not used". */
export function shown(diagnostics: readonly Diagnostic[]): string[] {
  return said(diagnostics).map((message, index) => `${message}; ${diagnostics[index]!.effect}`);
}
