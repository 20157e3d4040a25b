import type { Diagnostic } from '../core/diagnostics.ts';

/** The problem of an image file that the browser can't decode. */
export function imageProblem(file: string, found: string): Diagnostic {
  return {
    severity: 'warning',
    code: 'image/unknown',
    file,
    expected: 'a picture for a surface',
    found,
    effect: 'the surface is shown without it',
  };
}
