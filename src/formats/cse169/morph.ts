import type { MorphParts } from '../../core/character-parts.ts';
import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { baseName, pathStem } from '../file-entry.ts';
import { scan, type Scanner } from './scanner.ts';
import { closeRows, endsEarly } from './sections.ts';

const about = { area: 'morph', effect: 'the morph is not used' } as const;

/** Positions or normals of vertices at weight 1, absolute, as the file has them. */
interface Targets {
  readonly points: Uint32Array;
  /** (n) one-based line of each row. */
  readonly lines: Uint32Array;
  /** (n × 3) float64, so that the differences are rounded once. */
  readonly values: Float64Array;
}

export interface MorphFile {
  readonly file: string;
  readonly positions: Targets;
  readonly normals: Targets;
}

const keywords = new Set(['positions', 'normals']);
const isKeyword = (word: string): boolean => keywords.has(word);
const noLines = new Uint32Array(0);
const none: Targets = { points: noLines, lines: noLines, values: new Float64Array(0) };

/** Reads a `.morph` of CSE169: `positions K { index x y z … }` and `normals K { … }`, zero-based. */
export function readMorph(
  file: string,
  bytes: Uint8Array,
  limits: Limits = defaultLimits,
): Parsed<MorphFile> {
  const log = new DiagnosticLog(file);
  const scanner = scan(file, bytes, log, about, limits);
  if (!scanner) return log.finish<MorphFile>(undefined);
  const read = new Map<string, Targets>();
  while (scanner.sound()) {
    const word = scanner.keyword(isKeyword);
    if (scanner.reader.atEnd) break;
    if (read.has(word)) scanner.fail('duplicate', `one section "${word}"`, 'another');
    else if (isKeyword(word)) read.set(word, readTargets(scanner, word, limits.pointCount) ?? none);
    else if (scanner.reader.isWord) scanner.skipUnknown(isKeyword);
    else scanner.fail('token', '"positions" or "normals"');
  }
  scanner.checkEnd();
  if (read.size === 0 && scanner.sound()) scanner.fail('section', '"positions"', 'none');
  const positions = read.get('positions') ?? none;
  return log.finish({ file, positions, normals: read.get('normals') ?? none });
}

function clamp(value: number, largest: number): number {
  return Math.min(largest, Math.max(-largest, value));
}

function readTargets(scanner: Scanner, name: string, mostPoints: number): Targets | undefined {
  const count = scanner.count(`rows of ${name}`, 8, mostPoints);
  if (!scanner.sound()) return undefined;
  const opened = scanner.openIfAny();
  // Of several rows for one vertex the last one counts.
  const rows = new Map<number, { line: number; target: readonly number[] }>();
  for (let row = 0; row < count; row++) {
    if (endsEarly(scanner, name, count, row)) return undefined;
    const point = scanner.index('a vertex', mostPoints - 1);
    if (!scanner.sound()) return undefined;
    const { line } = scanner.reader;
    if (rows.has(point)) {
      const expected = `one row of ${name} for vertex ${point}`;
      scanner.warnOnce(name, 'duplicate', expected, 'another', 'the last one counts');
    }
    // A part is hidden by a target past what can be computed with, and is hidden at that bound too.
    const held = scanner
      .triple(name, Infinity)
      .map((value) => clamp(value, scanner.limits.coordinate));
    rows.set(point, { line, target: held });
    if (!scanner.sound()) return undefined;
  }
  if (!closeRows(scanner, name, count, opened)) return undefined;
  return {
    points: Uint32Array.from(rows.keys()),
    lines: Uint32Array.from(rows.values(), ({ line }) => line),
    values: Float64Array.from([...rows.values()].flatMap(({ target }) => target)),
  };
}

/**
 * Converts a morph to offsets from the skin to which it belongs. Differences that are only due to
 * rounding (morph files have three decimals, skins four) are kept, because the file contains them.
 *
 * @param positions (pointCount × 3) of the skin
 * @param normals (pointCount × 3) of the skin, unit
 */
export function morphOffsets(
  { file, positions: targets, normals: normalTargets }: MorphFile,
  positions: Float32Array,
  normals: Float32Array,
): Parsed<MorphParts> {
  const log = new DiagnosticLog(file);
  const pointCount = positions.length / 3;
  for (const { points, lines } of [targets, normalTargets]) {
    const outside = points.findIndex((point) => point >= pointCount);
    if (outside === -1) continue;
    log.error({
      code: 'morph/index',
      line: lines[outside]!,
      expected: `vertices from 0 to ${pointCount - 1}, which the skin has`,
      found: `${points[outside]!}`,
      effect: about.effect,
    });
    break;
  }
  return log.finish({
    file,
    name: pathStem(baseName(file)),
    points: targets.points,
    offsets: differences(targets, positions),
    normalPoints: normalTargets.points,
    normalOffsets: differences(unitTargets(normalTargets), normals),
  });
}

function differences({ points, values }: Targets, base: Float32Array): Float32Array {
  return Float32Array.from(values, (value, i) => {
    return value - base[points[Math.floor(i / 3)]! * 3 + (i % 3)]!;
  });
}

function unitTargets({ points, lines, values }: Targets): Targets {
  const unit = values.slice();
  for (let i = 0; i < unit.length; i += 3) {
    const length = Math.hypot(unit[i]!, unit[i + 1]!, unit[i + 2]!);
    if (length > 1e-12) for (let k = 0; k < 3; k++) unit[i + k] = unit[i + k]! / length;
  }
  return { points, lines, values: unit };
}
