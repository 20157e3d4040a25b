import type { SkinParts } from '../../core/character-parts.ts';
import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import type { Skin } from '../../core/skin.ts';
import { checkFloat32 } from '../text/check-float32.ts';
import { checkText } from '../text/check-text.ts';
import { growFloat32, growUint16, growUint32 } from '../text/growable.ts';
import { LineReader } from '../text/line-reader.ts';
import { encodeLines, writeFloat32 } from '../text/write-number.ts';

const effect = 'the mesh is shown without its weights';

/** The weights, and how many columns every row has: one a joint, less the root. */
export interface AttachParts extends SkinParts {
  readonly columnCount: number;
}

/**
 * Reads a 6.837 `.attach` (handout, 4.3) straight to sparse rows: a line a vertex, column i the weight
 * of joint i + 1 (joint 0 has none). Zeros are left out; blank lines may stand only at the end.
 */
export function readAttach(file: string, bytes: Uint8Array): Parsed<AttachParts> {
  const log = new DiagnosticLog(file);
  const text = checkText(bytes, log);
  if (!text) return log.finish<AttachParts>(undefined);
  const start = growUint32();
  const joints = growUint16();
  const weights = growFloat32();
  const reader = new LineReader(text);
  let columnCount = -1;
  let blank: { line: number } | undefined;
  start.push(0);
  while (reader.next()) {
    let column = 0;
    while (reader.token()) {
      const weight = checkFloat32(reader, `weight ${column + 1}`, 'attach', effect, log);
      column++;
      if (weight === 0) continue;
      joints.push(column);
      weights.push(weight);
    }
    if (column === 0) {
      blank ??= { line: reader.line };
      continue;
    }
    if (blank) reportBlank(blank, log);
    blank = undefined;
    if (columnCount === -1) columnCount = column;
    if (column !== columnCount) {
      log.error({
        code: 'attach/field-count',
        ...reader.linePlace,
        expected: `${columnCount} weights, as in the first row`,
        found: `${column}`,
        effect,
      });
    }
    start.push(weights.length);
  }
  if (columnCount === -1) {
    log.error({ code: 'attach/empty', expected: 'a row a vertex', found: 'no row', effect });
  }
  return log.finish({
    file,
    columnCount,
    start: start.finish(),
    joints: joints.finish(),
    weights: weights.finish(),
  });
}

function reportBlank(place: { line: number }, log: DiagnosticLog): void {
  const expected = 'a row of weights for every vertex';
  log.error({ code: 'attach/count', ...place, expected, found: 'a blank line', effect });
}

/** Writes all columns of all joints but the first in the file, whose weight the format leaves out. */
export function writeAttach(skin: Skin, skeleton: Skeleton): Uint8Array {
  const row = new Float32Array(skeleton.jointCount);
  const lines: string[] = [];
  for (let point = 0; point + 1 < skin.start.length; point++) {
    row.fill(0);
    for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
      const joint = skin.paletteJoint[skin.entries[i]!]!;
      const source = skeleton.sourceIndex[joint]!;
      row[source] = row[source]! + skin.weights[i]!;
    }
    lines.push(Array.from(row.subarray(1), writeFloat32).join(' '));
  }
  return encodeLines(lines);
}
