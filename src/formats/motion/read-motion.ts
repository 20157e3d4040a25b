import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { defaultLimits } from '../../core/limits.ts';
import { defaultFps } from '../../core/motion/clip-parts.ts';
import { baseName, pathStem } from '../file-entry.ts';
import { checkVersion, type JsonValue } from '../json/decoder.ts';
import { parseJson } from '../json/parse-json.ts';
import { decodeText } from '../text/decode-text.ts';
import { numberIn, warnOfOthers } from './fields.ts';
import type { Motion, MotionChannel } from './motion.ts';
import { kept, readChannel } from './read-channel.ts';
import { largestTime } from './read-keys.ts';

/** The fewest and the most frames a second. */
const [slowest, fastest] = [1, 1000];
/** More than any character has values. */
const mostChannels = defaultLimits.jointCount * 16;

const known = ['version', 'fps', 'range', 'channels'];

/**
 * Reads MOTION.json, whose channels name what they move; docs/formats/motion.md describes it. A
 * value that is wrong affects only its channel, which is kept for saving.
 */
export function readMotion(file: string, bytes: Uint8Array): Parsed<Motion> {
  return readMotionText(file, decodeText(bytes));
}

export function readMotionText(file: string, text: string): Parsed<Motion> {
  const log = new DiagnosticLog(file);
  const json = parseJson(text, { log, area: 'motion', effect: 'the motion is not used' });
  const fields = json?.record('an object with "channels"');
  const list = fields && checkVersion(fields) ? listIn(json!, fields) : undefined;
  if (!fields || !list) return { diagnostics: log.diagnostics };
  warnOfOthers(fields, known);
  const fps = readFps(fields.get('fps'));
  const listed = list.map((each) => readChannel(each.reporting({ effect: kept })));
  const unread = list.filter((_, at) => !listed[at]).map(({ value }) => value);
  const channels = withoutDoubles(listed.filter((each) => each !== undefined));
  const [start, end] = readRange(fields.get('range')) ?? rangeOfKeys(channels);
  const name = pathStem(baseName(file)).replace(/\.motion$/i, '');
  const value: Motion = { file, name, start, end, fps, channels, listed, unread };
  return { value, diagnostics: log.diagnostics };
}

function listIn(
  json: JsonValue,
  fields: ReadonlyMap<string, JsonValue>,
): readonly JsonValue[] | undefined {
  const channels = fields.get('channels');
  if (!channels) {
    json.fail('json', 'an object with "channels"');
    return undefined;
  }
  const { value } = channels;
  if (!Array.isArray(value) || value.length <= mostChannels) {
    return channels.list(mostChannels, '"channels" to be a list');
  }
  channels.fail('limit', `at most ${mostChannels} channels`, `${value.length}`);
  return undefined;
}

function readFps(json: JsonValue | undefined): number {
  if (!json) return defaultFps;
  const { value } = json;
  if (typeof value === 'number' && value >= slowest && value <= fastest) return value;
  const kind = typeof value === 'number' ? 'range' : 'json';
  const expected = `frames a second from ${slowest} to ${fastest}`;
  json.reporting({ effect: `${defaultFps} are used`, severity: 'warning' }).fail(kind, expected);
  return defaultFps;
}

function readRange(json: JsonValue | undefined): readonly [number, number] | undefined {
  if (!json) return undefined;
  const effect = 'the range of the keys is used';
  const part = json.reporting({ effect, severity: 'warning' });
  if (!part.numbers([2], 'a range as [start, end]')) return undefined;
  const [start, end] = [0, 1].map((at) =>
    numberIn(part.member(at), largestTime, 'a time in seconds'),
  );
  if (start === undefined || end === undefined) return undefined;
  if (start <= end) return [start, end];
  json.warn('order', 'a range with its start first', `[${start},${end}]`, 'they are swapped');
  return [end, start];
}

/** From the first key to the last one. */
function rangeOfKeys(channels: readonly MotionChannel[]): readonly [number, number] {
  let [start, end] = [Infinity, -Infinity];
  for (const { curve } of channels) {
    start = Math.min(start, curve.keys[0]?.time ?? Infinity);
    end = Math.max(end, curve.keys.at(-1)?.time ?? -Infinity);
  }
  return start <= end ? [start, end] : [0, 0];
}

/** Of several channels for one target the last one counts. */
function withoutDoubles(channels: readonly MotionChannel[]): readonly MotionChannel[] {
  const last = new Map(channels.map((channel) => [channel.target.names[0], channel]));
  return channels.filter((channel) => {
    const [name] = channel.target.names;
    if (last.get(name) === channel) return true;
    channel.place.warn('duplicate', 'one channel for each target', name, 'the last one counts');
    return false;
  });
}
