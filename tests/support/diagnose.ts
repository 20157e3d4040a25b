import { type Diagnostic, formatDiagnostic } from '../../src/core/diagnostics.ts';

/** Diagnostics as the command line shows them: "error: FILE:LINE:COL: … [code]; effect". */
export function shown(diagnostics: readonly Diagnostic[]): string[] {
  return diagnostics.map((diagnostic) => {
    const { severity, code, effect } = diagnostic;
    return `${severity}: ${formatDiagnostic(diagnostic)} [${code}]; ${effect}`;
  });
}
