import type { DofParts, JointParts, SkeletonParts } from '../../core/character-parts.ts';
import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { DofKind, noParent, type Skeleton } from '../../core/skeleton.ts';
import { checkText } from '../text/check-text.ts';
import { checkFloat32 } from '../text/check-float32.ts';
import { LineReader } from '../text/line-reader.ts';
import { encodeLines, writeFloat64 } from '../text/write-number.ts';
import { jointNames } from './joint-names.ts';

const effect = 'the skeleton is not used';

interface JointLine {
  readonly line: number;
  readonly offset: readonly [number, number, number];
  readonly parent: number;
}

/**
 * Reads a 6.837 `.skel` (handout, 3.2.1): a joint a line, `tx ty tz parent`, relative to the parent;
 * -1 is a root. Parents may follow their children; blank lines and `#` comments count for nothing.
 */
export function readSkel(file: string, bytes: Uint8Array): Parsed<SkeletonParts> {
  const log = new DiagnosticLog(file);
  const text = checkText(bytes, log);
  if (!text) return log.finish<SkeletonParts>(undefined);
  const lines: JointLine[] = [];
  const reader = new LineReader(text);
  while (reader.next()) {
    if (reader.countTokens() === 0) continue;
    const joint = readJoint(reader, log);
    if (joint) lines.push(joint);
  }
  if (!log.failed) checkRoots(lines, log);
  const names = jointNames(lines.map(({ parent }) => parent));
  const joints = lines.map((line, index) => jointOf(line, names[index]!));
  return log.finish({ file, joints });
}

function readJoint(reader: LineReader, log: DiagnosticLog): JointLine | undefined {
  const fieldCount = reader.countTokens();
  if (fieldCount !== 4) {
    log.error({
      code: 'skel/field-count',
      ...reader.linePlace,
      expected: '"tx ty tz parent"',
      found: `${fieldCount} fields`,
      effect,
    });
    return undefined;
  }
  const offset = ['x', 'y', 'z'].map((axis) => {
    reader.token();
    return checkFloat32(reader, axis, 'skel', effect, log);
  });
  reader.token();
  const parent = reader.integer();
  if (!(parent >= noParent)) {
    log.error({
      code: 'skel/integer',
      ...reader.place,
      expected: '-1 or the index of a joint',
      found: reader.text(),
      effect,
    });
  }
  return { line: reader.line, offset: offset as [number, number, number], parent };
}

function checkRoots(lines: readonly JointLine[], log: DiagnosticLog): void {
  if (lines.length === 0) {
    log.error({ code: 'skel/empty', expected: 'at least one joint', found: 'none', effect });
    return;
  }
  for (const { line, parent } of lines) {
    if (parent < lines.length) continue;
    const expected = `a parent from -1 to ${lines.length - 1}`;
    log.error({ code: 'skel/parent', line, expected, found: `${parent}`, effect });
  }
  const roots = lines.filter(({ parent }) => parent === noParent);
  if (roots.length > 1) {
    log.warn({
      code: 'skel/root',
      line: roots[1]!.line,
      expected: 'one root (parent -1)',
      found: `${roots.length} roots`,
      effect: 'they are read as a forest',
    });
  } else if (roots.length === 1 && lines[0]!.parent !== noParent) {
    log.warn({
      code: 'skel/root',
      line: roots[0]!.line,
      expected: 'the root to be the first joint',
      found: `joint ${lines.indexOf(roots[0]!)}`,
      effect: 'joint 0 still has no column of weights, as the format has it',
    });
  }
}

function jointOf({ line, offset, parent }: JointLine, name: string): JointParts {
  const dofs = parent === noParent ? [...slides, ...hinges] : hinges;
  return { name, line, parent, restOffset: offset, dofs };
}

const axes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const;

/** R = Rx · Ry · Rz, as the course's program computes it: z turns first. */
const hinges: readonly DofParts[] = axes.map((axis) => ({ kind: DofKind.hinge, axis }));
const slides: readonly DofParts[] = axes.map((axis) => ({ kind: DofKind.slide, axis }));

/** Writes joints in file order; names and rest rotations have no place in this format. */
export function writeSkel(skeleton: Skeleton): Uint8Array {
  const lines = Array.from(skeleton.jointOfSource, (joint) => {
    const offset = skeleton.restOffsets.subarray(joint * 3, joint * 3 + 3);
    const parent = skeleton.parents[joint]!;
    const parentIndex = parent === noParent ? noParent : skeleton.sourceIndex[parent]!;
    return [...Array.from(offset, writeFloat64), parentIndex].join(' ');
  });
  return encodeLines(lines);
}
