import { type Diagnostic, type DiagnosticCode, DiagnosticLog } from '../../core/diagnostics.ts';
import type { Mesh } from '../../core/mesh.ts';
import { materialText } from '../obj/material-text.ts';

/** Something that a file can't hold, how often it occurs, and what replaces it. */
export interface Loss {
  readonly what: string;
  readonly count: number;
  readonly effect: string;
}

/** Reports a warning for each loss that occurs. */
export function reportLosses(
  file: string,
  code: DiagnosticCode,
  losses: readonly Loss[],
): readonly Diagnostic[] {
  const log = new DiagnosticLog(file);
  for (const { what, count, effect } of losses) {
    if (count === 0) continue;
    log.warn({ code, expected: 'what the format holds', found: `${what}: ${count}`, effect });
  }
  return log.diagnostics;
}

/** Returns what an `.obj` can't hold of a mesh. */
export function objLosses(file: string, { submeshes }: Mesh): readonly Diagnostic[] {
  const changed = submeshes.filter(({ material }) => materialText(material) !== material);
  const effect = 'they are written without line ends, and without blanks and \\ at their ends';
  return reportLosses(file, 'obj/lost', [
    { what: 'names of materials', count: changed.length, effect },
  ]);
}
