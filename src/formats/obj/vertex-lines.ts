import { DiagnosticLog } from '../../core/diagnostics.ts';
import type { Limits } from '../../core/limits.ts';
import { growUint32 } from '../text/growable.ts';
import { LineReader } from '../text/line-reader.ts';
import { continued } from './continued.ts';

const letterV = 0x76;

/** The lines of all `v` of an OBJ, to tell where a vertex that comes too late does come. */
export function vertexLines(bytes: Uint8Array, limits: Limits): Uint32Array {
  const lines = growUint32();
  // A second pass over what is being read, which says all that there is to say.
  const reader = new LineReader(bytes, new DiagnosticLog(''), { continued, limits });
  while (reader.next() && lines.length < limits.pointCount) {
    if (!reader.token() || reader.tokenEnd - reader.tokenStart !== 1) continue;
    if (bytes[reader.tokenStart] === letterV) lines.push(reader.line);
  }
  return lines.finish();
}
