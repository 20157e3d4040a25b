import {
  defaultFps,
  type ScalarChannelParts,
  type ScalarClipParts,
  type Extrapolation,
} from '../../core/motion/clip-parts.ts';
import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { baseName, pathStem } from '../file-entry.ts';
import { readKeys, tellNone } from './anim-keys.ts';
import { largest, scan, type Scanner } from './scanner.ts';

const about = { area: 'anim', effect: 'the clip is not used' } as const;

const outer = new Set(['animation']);
const inner = new Set(['range', 'numchannels', 'channel']);
const ofChannel = new Set(['extrapolate', 'keys']);
const isOuter = (word: string): boolean => outer.has(word);
const isInner = (word: string): boolean => inner.has(word);
const isOfChannel = (word: string): boolean => ofChannel.has(word);

const extrapolations: ReadonlySet<string> = new Set<Extrapolation>([
  ...(['constant', 'linear', 'cycle', 'cycle_offset', 'bounce'] as const),
]);
const isExtrapolation = (word: string): word is Extrapolation => extrapolations.has(word);

/** The clip as it was read, before its channels are bound to a skeleton. */
interface Draft {
  range?: readonly [number, number];
  declaredCount?: number;
  readonly channels: ScalarChannelParts[];
}

/**
 * Reads an `.anim` of CSE169 (project 3): `animation { range t0 t1 numchannels C channel { … } …
 * }`. Its channels have no targets yet, because the file does not say to which skeleton they
 * belong.
 */
export function readAnim(
  file: string,
  bytes: Uint8Array,
  limits: Limits = defaultLimits,
): Parsed<ScalarClipParts> {
  const log = new DiagnosticLog(file);
  const scanner = scan(file, bytes, log, about, limits);
  if (!scanner) return log.finish<ScalarClipParts>(undefined);
  const draft: Draft = { channels: [] };
  if (scanner.keyword(isOuter) !== 'animation') scanner.fail('token', '"animation"');
  else if (scanner.open()) readAnimation(scanner, draft);
  while (scanner.sound() && scanner.reader.next()) {
    scanner.trailing(isOuter, 'nothing after the animation');
  }
  scanner.checkEnd();
  return log.finish(scanner.sound() ? finishClip(file, draft, log) : undefined);
}

function readAnimation(scanner: Scanner, draft: Draft): void {
  const { reader } = scanner;
  while (scanner.sound()) {
    const word = scanner.keyword(isInner);
    if (reader.isClose) return;
    if (word === 'range') {
      const start = scanner.number('the start of the range', largest.time);
      if (scanner.sound()) draft.range = [start, scanner.number('its end', largest.time)];
    } else if (word === 'numchannels') {
      draft.declaredCount = scanner.index('the number of channels', 0xffffffff);
    } else if (word === 'channel') readChannel(scanner, draft);
    else if (reader.isWord) scanner.skipUnknown(isInner);
    else scanner.fail('token', '"channel" or "}" for the animation');
  }
}

function readChannel(scanner: Scanner, draft: Draft): void {
  const { reader, limits } = scanner;
  if (draft.channels.length >= limits.jointCount * 3 + 3) {
    scanner.fail('limit', `at most ${limits.jointCount * 3 + 3} channels`);
    return;
  }
  const mark = reader.mark();
  // Some files number their channels, as in "channel 14{"; the order in the file counts
  // nevertheless.
  if (!(reader.next() && reader.looksNumeric)) reader.back(mark);
  if (!scanner.open()) return;
  let rules: [Extrapolation, Extrapolation] = ['constant', 'constant'];
  let keys: ScalarChannelParts['keys'] | undefined;
  while (scanner.sound()) {
    const word = scanner.keyword(isOfChannel);
    if (reader.isClose) break;
    if (word === 'extrapolate') rules = [readRule(scanner), readRule(scanner)];
    else if (word === 'keys') keys = readKeys(scanner);
    else if (reader.isWord) scanner.skipUnknown(isOfChannel);
    else scanner.fail('token', '"}" for the channel');
  }
  if (!keys && scanner.sound()) tellNone(scanner);
  draft.channels.push({ target: null, before: rules[0], after: rules[1], keys: keys ?? [] });
}

function readRule(scanner: Scanner): Extrapolation {
  if (!scanner.sound()) return 'constant';
  const word = scanner.keyword(isExtrapolation);
  if (isExtrapolation(word)) return word;
  scanner.fail('token', 'constant, linear, cycle, cycle_offset or bounce');
  return 'constant';
}

function finishClip(file: string, draft: Draft, log: DiagnosticLog): ScalarClipParts | undefined {
  const { channels, declaredCount } = draft;
  if (channels.length === 0) {
    const { effect } = about;
    log.error({ code: 'anim/empty', expected: 'at least one channel', found: 'none', effect });
    return undefined;
  }
  if (declaredCount !== undefined && declaredCount !== channels.length) {
    log.warn({
      code: 'anim/count',
      expected: `${declaredCount} channels, as the file says`,
      found: `${channels.length}`,
      effect: 'those that there are are used',
    });
  }
  const [start, end] = draft.range ?? rangeOfKeys(channels);
  if (start > end) {
    const found = `${start} ${end}`;
    const effect = 'they are swapped';
    log.warn({ code: 'anim/order', expected: 'a range with its start first', found, effect });
  }
  const name = pathStem(baseName(file));
  return {
    file,
    name,
    start: Math.min(start, end),
    end: Math.max(start, end),
    fps: defaultFps,
    channels,
  };
}

function rangeOfKeys(channels: readonly ScalarChannelParts[]): [number, number] {
  let [start, end] = [Infinity, -Infinity];
  for (const { keys } of channels) {
    start = Math.min(start, keys[0]?.time ?? Infinity);
    end = Math.max(end, keys.at(-1)?.time ?? -Infinity);
  }
  return start <= end ? [start, end] : [0, 0];
}
