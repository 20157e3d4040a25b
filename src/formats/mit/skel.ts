import type { DofParts, JointParts, SkeletonParts } from '../../core/character-parts.ts';
import { DiagnosticLog, type Parsed, type Place } from '../../core/diagnostics.ts';
import { loadPart } from '../../core/failure.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { DofKind, noParent } from '../../core/skeleton.ts';
import { checkFloat32 } from '../text/check-float32.ts';
import type { LineReader } from '../text/line-reader.ts';
import { openText } from '../text/open-text.ts';
import { hasTopology, makeHuman } from './human-joint-names.ts';

const effect = 'the skeleton is not used';

interface JointLine {
  readonly offset: readonly [number, number, number];
  readonly parent: number;
  /** The place of the parent's number. */
  readonly place: Place;
}

/**
 * Reads a 6.837 `.skel` (handout, 3.2.1): a joint per line, `tx ty tz parent`, relative to the
 * parent; -1 marks a root. Parents may follow their children; blank lines and `#` comments are not
 * counted. The builder of all skeletons checks that parents exist and lead to a root.
 */
export async function readSkel(
  file: string,
  bytes: Uint8Array,
  limits: Limits = defaultLimits,
): Promise<Parsed<SkeletonParts>> {
  const log = new DiagnosticLog(file);
  const reader = openText(file, bytes, log, { limits });
  if (!reader) return log.finish<SkeletonParts>(undefined);
  const lines: JointLine[] = [];
  while (reader.next() && lines.length <= limits.jointCount) {
    if (reader.countTokens() === 0) continue;
    const joint = readJoint(reader, log);
    if (joint) lines.push(joint);
  }
  if (lines.length > limits.jointCount) {
    const expected = `at most ${limits.jointCount} joints`;
    log.error({ code: 'skel/limit', ...lines.at(-1)!.place, expected, found: 'more', effect });
  }
  if (!log.failed) checkRoots(lines, log);
  const names = await namesOf(lines.map(({ parent }) => parent));
  const joints = lines.map((line, index) => jointOf(line, names[index]!));
  return log.finish({ file, joints });
}

/** The human is in the first picture, which does not wait for the names of other skeletons. */
async function namesOf(parents: readonly number[]): Promise<readonly string[]> {
  if (hasTopology(makeHuman, parents)) return makeHuman.names;
  const { jointNames } = await loadPart(import('./joint-names.ts'));
  return jointNames(parents);
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
    const largest = reader.limits.coordinate;
    return checkFloat32(reader, { what: axis, area: 'skel', effect, largest }, log);
  });
  reader.token();
  const parent = reader.integer();
  if (!Number.isSafeInteger(parent) || parent < noParent) {
    log.error({
      code: 'skel/integer',
      ...reader.place,
      expected: '-1 or the index of a joint',
      found: reader.text(),
      effect,
    });
  }
  return { offset: offset as [number, number, number], parent, place: reader.place };
}

function checkRoots(lines: readonly JointLine[], log: DiagnosticLog): void {
  if (lines.length === 0) {
    log.error({ code: 'skel/empty', expected: 'at least one joint', found: 'none', effect });
    return;
  }
  const roots = lines.filter(({ parent }) => parent === noParent);
  if (roots.length > 1) {
    log.warn({
      code: 'skel/root',
      ...roots[1]!.place,
      expected: 'one root (parent -1)',
      found: `${roots.length} roots`,
      effect: 'they are read as a forest',
    });
  } else if (roots.length === 1 && lines[0]!.parent !== noParent) {
    log.warn({
      code: 'skel/root',
      ...roots[0]!.place,
      expected: 'the root to be the first joint',
      found: `joint ${lines.indexOf(roots[0]!)}`,
      effect: 'joint 0 still has no column of weights, as the format has it',
    });
  }
}

function jointOf({ offset, parent, place }: JointLine, name: string): JointParts {
  const dofs = parent === noParent ? [...slides, ...hinges] : hinges;
  return { name, place, parent, restOffset: offset, dofs };
}

const axes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const;

/** R = Rx · Ry · Rz, as the course's program computes it: z is applied first. */
const hinges: readonly DofParts[] = axes.map((axis) => ({ kind: DofKind.hinge, axis }));
const slides: readonly DofParts[] = axes.map((axis) => ({ kind: DofKind.slide, axis }));
