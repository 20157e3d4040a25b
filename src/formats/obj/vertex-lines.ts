import { DiagnosticLog } from '../../core/diagnostics.ts';
import type { Limits } from '../../core/limits.ts';
import { growUint32 } from '../text/growable.ts';
import { LineReader } from '../text/line-reader.ts';
import { continued } from './continued.ts';

const letterV = 0x76;

/**
 * Returns the lines of all `v` of an OBJ, so that a message can say where a late vertex is defined.
 */
export function vertexLines(bytes: Uint8Array, limits: Limits): Uint32Array {
  const lines = growUint32();
  // A second pass over the file; its problems have already been reported by the first.
  const reader = new LineReader(bytes, new DiagnosticLog(''), { continued, limits });
  while (reader.next() && lines.length < limits.pointCount) {
    if (!reader.token() || reader.tokenEnd - reader.tokenStart !== 1) continue;
    if (bytes[reader.tokenStart] === letterV) lines.push(reader.line);
  }
  return lines.finish();
}
