import type { MorphParts } from '../../core/character-parts.ts';
import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { MmdMorphs } from './mmd-parts.ts';
import type { BinaryReader } from '../binary/binary-reader.ts';
import type { BinaryRecord } from '../binary/binary-record.ts';
import { uniqueNames } from '../unique-names.ts';
import { decodeName } from './decode-name.ts';
import { Findings } from './findings.ts';
import { mirrored } from './mirror.ts';

const [headSize, entrySize] = [25, 16];
const basePanel = 0;

/** A morph as stored in the file. */
interface Section {
  readonly name: string;
  readonly panel: number;
  readonly count: number;
  readonly entries: BinaryRecord;
}

export interface PmdMorphs {
  readonly morphs: readonly MorphParts[];
  readonly mmd: MmdMorphs;
}

export const noMorphs: PmdMorphs = {
  morphs: [],
  mmd: { basePoints: new Uint32Array(0), basePositions: new Float32Array(0), listed: [] },
};

/**
 * Reads the morphs. The first one of panel 0 is the base, which is not a morph: it lists the
 * vertices that morphs move. The other morphs give offsets for indices into that list.
 */
export function readMorphs(
  reader: BinaryReader,
  file: string,
  pointCount: number,
  largest: number,
  log: DiagnosticLog,
): PmdMorphs | undefined {
  const sections = readSections(reader);
  if (!sections) return undefined;
  const findings = new Findings();
  const baseIndex = sections.findIndex(({ panel }) => panel === basePanel);
  if (sections.length > 0 && baseIndex === -1) {
    const effect = 'the morphs are left out';
    log.warn({ code: 'pmd/section', expected: 'a base morph', found: 'none', effect });
  }
  const base = readBase(sections[baseIndex], pointCount, largest, findings);
  const isMorph = (_: Section, index: number): boolean => base !== undefined && index !== baseIndex;
  const chosen = sections.filter(isMorph);
  const names = uniqueNames(
    chosen.map(({ name }) => name),
    'morph',
  );
  const morphs = chosen.map((section, index): MorphParts => {
    const moved = offsetsOf(section, base!.pointOf, largest, findings);
    const normals = { normalPoints: new Uint32Array(0), normalOffsets: new Float32Array(0) };
    return { file, name: names[index]!, ...moved, ...normals };
  });
  const expected = 'morphs of vertices that are there, by numbers';
  findings.warn(log, 'pmd/index', expected, 'what is not is left out of them');
  let next = 0;
  const listed = sections.map((section, index) => {
    const morph = isMorph(section, index) ? next++ : -1;
    return { fileName: section.name, panel: section.panel, morph };
  });
  const { basePoints, basePositions } = base ?? noMorphs.mmd;
  return { morphs, mmd: { basePoints, basePositions, listed } };
}

function readSections(reader: BinaryReader): Section[] | undefined {
  const { offset } = reader;
  const count = reader.integer(2, 'the number of morphs');
  if (count === undefined || !reader.fits(count, headSize, 'morphs', offset)) return undefined;
  const sections: Section[] = [];
  for (let index = 0; index < count; index++) {
    const head = reader.record(headSize, `morph ${index}`);
    if (!head) return undefined;
    const size = head.u32(20);
    const what = `vertices of morph ${index}`;
    if (!reader.fits(size, entrySize, what, head.offset + 20)) return undefined;
    const entries = reader.record(size * entrySize, what)!;
    sections.push({
      name: decodeName(head.bytes(0, 20)),
      panel: head.u8(24),
      count: size,
      entries,
    });
  }
  return sections;
}

/** The points of the base, and for each of its entries the point, or -1 if there is none. */
function readBase(
  section: Section | undefined,
  pointCount: number,
  largest: number,
  findings: Findings,
): (Pick<MmdMorphs, 'basePoints' | 'basePositions'> & { pointOf: Int32Array }) | undefined {
  if (!section) return undefined;
  const { indices, targets, vectors } = entriesOf(section, pointCount, largest, findings, 'base');
  const pointOf = new Int32Array(section.count).fill(-1);
  for (let i = 0; i < indices.length; i++) pointOf[indices[i]!] = targets[i]!;
  return { basePoints: targets, basePositions: vectors, pointOf };
}

function offsetsOf(
  section: Section,
  pointOf: Int32Array,
  largest: number,
  findings: Findings,
): Pick<MorphParts, 'points' | 'offsets'> {
  const name = `"${section.name}"`;
  const { targets, vectors } = entriesOf(section, pointOf.length, largest, findings, name);
  let kept = 0;
  for (let i = 0; i < targets.length; i++) {
    const point = pointOf[targets[i]!]!;
    if (point === -1) continue;
    targets[kept] = point;
    vectors.copyWithin(kept * 3, i * 3, i * 3 + 3);
    kept++;
  }
  return kept === targets.length
    ? { points: targets, offsets: vectors }
    : { points: targets.slice(0, kept), offsets: vectors.slice(0, kept * 3) };
}

/** The valid entries of a morph: their places in the file's list, what they move, and how far. */
interface Entries {
  readonly indices: Uint32Array;
  readonly targets: Uint32Array;
  /** (count × 3) right-handed. */
  readonly vectors: Float32Array;
}

/**
 * Returns the valid entries, mirrored. Larger values than can be computed with are clamped: models
 * hide a part with a morph of 1e30 or of infinity, and it is hidden by the clamped value too.
 */
function entriesOf(
  { count, entries }: Section,
  targetCount: number,
  largest: number,
  findings: Findings,
  name: string,
): Entries {
  const indices = new Uint32Array(count);
  const targets = new Uint32Array(count);
  const vectors = new Float32Array(count * 3);
  let kept = 0;
  for (let index = 0; index < count; index++) {
    const at = index * entrySize;
    const target = entries.u32(at);
    const x = entries.f32(at + 4);
    const y = entries.f32(at + 8);
    const z = entries.f32(at + 12);
    const isSound = !Number.isNaN(x + y + z) || !entries.triple(at + 4).some(Number.isNaN);
    if (target < targetCount && isSound) {
      indices[kept] = index;
      targets[kept] = target;
      vectors[kept * 3] = held(x, largest);
      vectors[kept * 3 + 1] = held(y, largest);
      vectors[kept * 3 + 2] = mirrored(held(z, largest));
      kept++;
    } else
      findings.add(entries.offset + at, `${isSound ? target : [x, y, z].join(' ')}, morph ${name}`);
  }
  if (kept === count) return { indices, targets, vectors };
  return {
    indices: indices.slice(0, kept),
    targets: targets.slice(0, kept),
    vectors: vectors.slice(0, kept * 3),
  };
}

function held(value: number, largest: number): number {
  return Math.min(largest, Math.max(-largest, value));
}
