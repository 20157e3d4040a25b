import type { JointParts, SkeletonParts } from '../../core/character-parts.ts';
import { DiagnosticLog, type Parsed, type Place } from '../../core/diagnostics.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { noParent } from '../../core/skeleton.ts';
import { ballHinges, rootSlides, type Triple } from './joint-dofs.ts';
import { uniqueNames } from '../unique-names.ts';
import { largest, scan, type Scanner } from './scanner.ts';

const about = { area: 'skel', effect: 'the skeleton is not used' } as const;

/** A joint while its block is read, with the defaults of the assignment. */
interface Draft {
  readonly name: string;
  readonly line: number;
  readonly parent: number;
  /** The place of each of its properties in the file; of a repeated property, the last one. */
  readonly places: Map<string, Place>;
  offset: Triple;
  boxmin: Triple;
  boxmax: Triple;
  pose: Triple;
  readonly limits: [Range | undefined, Range | undefined, Range | undefined];
}

type Range = readonly [number, number];

const limitWords = ['rotxlimit', 'rotylimit', 'rotzlimit'];
const keywords = new Set([...['balljoint', 'offset', 'boxmin', 'boxmax', 'pose'], ...limitWords]);
const isKeyword = (word: string): boolean => keywords.has(word);

/**
 * Reads a `.skel` of CSE169 (Skeleton.md, 1.1): nested `balljoint NAME { … }`. Joints are numbered
 * depth first, in the order of the file. Angles are in radians.
 */
export function readSkel(
  file: string,
  bytes: Uint8Array,
  limits: Limits = defaultLimits,
): Parsed<SkeletonParts> {
  const log = new DiagnosticLog(file);
  const scanner = scan(file, bytes, log, about, limits);
  if (!scanner) return log.finish<SkeletonParts>(undefined);
  const drafts = readTree(scanner);
  if (!scanner.sound()) return log.finish<SkeletonParts>(undefined);
  const names = uniqueNames(drafts.map(({ name }) => name));
  const joints = drafts.map((draft, index) => finishJoint(draft, names[index]!, log));
  reportDegrees(drafts, names, log);
  return log.finish({ file, joints });
}

/**
 * Uses an explicit stack instead of recursion, because a file may nest a hundred thousand blocks.
 */
function readTree(scanner: Scanner): Draft[] {
  const { reader, limits } = scanner;
  const drafts: Draft[] = [];
  const open: number[] = [];
  while (scanner.sound()) {
    const word = scanner.keyword(isKeyword);
    if (reader.atEnd) {
      finishTree(scanner, drafts, open);
      break;
    } else if (word === 'balljoint') {
      if (open.length >= limits.depth) scanner.fail('depth', `at most ${limits.depth} levels`);
      else if (drafts.length >= limits.jointCount)
        scanner.fail('limit', `at most ${limits.jointCount} joints`);
      else openJoint(scanner, drafts, open);
    } else if (open.length === 0) {
      if (drafts.length === 0) scanner.fail('token', '"balljoint"');
      else scanner.trailing(isKeyword, 'nothing after the root joint');
    } else if (reader.isClose) open.pop();
    else if (reader.isOpen) scanner.fail('token', 'a property or a joint');
    else if (isKeyword(word)) readProperty(scanner, word, drafts[open.at(-1)!]!);
    else scanner.skipUnknown(isKeyword);
  }
  return drafts;
}

function openJoint(scanner: Scanner, drafts: Draft[], open: number[]): void {
  const { reader } = scanner;
  const { line } = reader;
  const parent = open.at(-1) ?? noParent;
  if (parent === noParent && drafts.length > 0) {
    const effect = 'they are read as a forest';
    scanner.warnOnce('root', 'root', 'one root joint', 'another', effect);
  }
  let name = '';
  if (scanner.openIfAny()) {
    const effect = 'it is shown by its number';
    scanner.warnOnce('name', 'name', 'a name', reader.text(), effect);
  } else {
    reader.next();
    name = reader.isWord ? reader.text() : '';
    if (name === '') scanner.fail('token', 'a name');
    else scanner.open();
  }
  const box = 0.1;
  open.push(drafts.length);
  drafts.push({
    name,
    line,
    parent,
    places: new Map(),
    offset: [0, 0, 0],
    boxmin: [-box, -box, -box],
    boxmax: [box, box, box],
    pose: [0, 0, 0],
    limits: [undefined, undefined, undefined],
  });
}

function finishTree(scanner: Scanner, drafts: readonly Draft[], open: readonly number[]): void {
  scanner.checkEnd();
  const inner = drafts[open.at(-1) ?? -1];
  if (inner) scanner.fail('end', `"}" for joint "${inner.name}" opened at line ${inner.line}`);
  else if (drafts.length === 0) scanner.fail('empty', '"balljoint"', 'no joint');
}

function readProperty(scanner: Scanner, word: string, joint: Draft): void {
  if (joint.places.has(word)) {
    const what = `one "${word}" a joint`;
    scanner.warnOnce(`duplicate ${word}`, 'duplicate', what, 'another', 'the last one counts');
  }
  joint.places.set(word, scanner.reader.place);
  if (word === 'offset' || word === 'boxmin' || word === 'boxmax') {
    joint[word] = scanner.triple(word);
  } else if (word === 'pose') joint.pose = scanner.triple(word, largest.angle);
  else {
    const low = scanner.number(`${word} min`, largest.angle);
    if (!scanner.sound()) return;
    const high = scanner.number(`${word} max`, largest.angle);
    const axis = limitWords.indexOf(word);
    if (low > high) {
      const effect = 'they are swapped';
      scanner.warn('limits', `${word} with min below max`, `${low} ${high}`, effect);
    }
    joint.limits[axis] = low > high ? [high, low] : [low, high];
  }
}

function finishJoint(draft: Draft, name: string, log: DiagnosticLog): JointParts {
  const { places, parent, offset, boxmin, boxmax, pose, limits } = draft;
  if ([0, 1, 2].some((axis) => boxmin[axis]! > boxmax[axis]!)) {
    log.warn({
      code: 'skel/box',
      ...(places.get('boxmin') ?? places.get('boxmax')),
      expected: `boxmin of "${name}" below its boxmax`,
      found: `${boxmin.join(' ')} and ${boxmax.join(' ')}`,
      effect: 'they are swapped where they are not',
    });
  }
  const clamped = pose.map((value, axis) => {
    // Without a pose in the file, it is the default pose that exceeds the limits.
    const place = places.get('pose') ?? places.get(limitWords[axis]!);
    return clamp(value, limits[axis], name, axis, place, log);
  });
  const hinges = ballHinges([clamped[0]!, clamped[1]!, clamped[2]!], limits);
  return {
    name,
    fileName: draft.name,
    parent,
    restOffset: offset,
    dofs: parent === noParent ? [...rootSlides, ...hinges] : hinges,
    displayBox: [
      ...boxmin.map((low, axis) => Math.min(low, boxmax[axis]!)),
      ...boxmin.map((low, axis) => Math.max(low, boxmax[axis]!)),
    ],
  };
}

/** The assignment clamps a pose to the limits before it is shown. */
function clamp(
  value: number,
  range: Range | undefined,
  name: string,
  axis: number,
  place: Place | undefined,
  log: DiagnosticLog,
): number {
  if (!range || (value >= range[0] && value <= range[1])) return value;
  const clamped = value < range[0] ? range[0] : range[1];
  log.warn({
    code: 'skel/range',
    ...place,
    expected: `pose ${'xyz'[axis]!} of "${name}" within its limits, ${range[0]} to ${range[1]}`,
    found: String(value),
    effect: `it is clamped to ${clamped}`,
  });
  return clamped;
}

function reportDegrees(
  drafts: readonly Draft[],
  names: readonly string[],
  log: DiagnosticLog,
): void {
  const joint = drafts.findIndex(({ pose }) => pose.some((angle) => Math.abs(angle) > 2 * Math.PI));
  if (joint === -1) return;
  const { places, pose } = drafts[joint]!;
  log.warn({
    code: 'skel/degrees',
    ...places.get('pose'),
    expected: `angles in radians for "${names[joint]!}"`,
    found: pose.join(' '),
    effect: 'they are used as radians, more than a full turn',
  });
}
