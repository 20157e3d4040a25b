import type { Character } from '../../core/character.ts';
import { defaultLimits } from '../../core/limits.ts';
import type { ClipParts } from '../../core/motion/clip-parts.ts';
import { channelKey } from '../../core/motion/targets.ts';
import type { JsonValue } from '../../formats/json/decoder.ts';
import type { Actor } from '../scene.ts';
import { readChannel, writeChannel } from './channel-json.ts';
import { numberWithin, text } from './codec.ts';
import { type Codecs, readFields, writeFields } from './fields.ts';
import { indexOfKey, keyAt } from '../../formats/json/keys.ts';

const { coordinate } = defaultLimits;

/** The fields of a clip that do not depend on its character. */
const plainFields: Codecs<Omit<ClipParts, 'channels' | 'unread'>> = {
  file: text,
  name: text,
  start: numberWithin(-coordinate, coordinate),
  end: numberWithin(-coordinate, coordinate),
  fps: numberWithin(1e-6, 1e6),
};

/** More clips and channels than a character can be worked with. */
const [mostClips, mostChannels] = [10_000, 1_000_000];

/**
 * Returns the clips of an actor, or nothing if they are those of its files. A clip that is still as
 * in its file is written by its key there, any other with all that it has.
 */
export function writeClips({ clips, character }: Actor): readonly unknown[] | undefined {
  if (sameClips(clips, character.clips)) return undefined;
  const names = character.clips.map(({ name }) => name);
  return clips.map((clip) => {
    const inFile = character.clips.indexOf(clip);
    return inFile < 0 ? writeClip(clip, character) : keyAt(names, inFile);
  });
}

function sameClips(a: readonly ClipParts[], b: readonly ClipParts[]): boolean {
  return a.length === b.length && a.every((clip, at) => clip === b[at]);
}

function writeClip(clip: ClipParts, character: Character): unknown {
  const { channels, unread } = clip;
  return {
    ...writeFields(plainFields, clip),
    channels: channels.map((channel) => writeChannel(channel, character)),
    ...(unread && { unread }),
  };
}

/** Reads clips; one that is not there or is none is reported and undefined in the list. */
export function readClips(
  json: JsonValue,
  character: Character,
): readonly (ClipParts | undefined)[] | undefined {
  const list = json.list(mostClips, `a list of at most ${mostClips} clips`);
  return list?.map((item) =>
    typeof item.value === 'string' ? clipOfFile(item, character) : readClip(item, character),
  );
}

function clipOfFile(json: JsonValue, { clips }: Character): ClipParts | undefined {
  const names = clips.map(({ name }) => name);
  const found = clips[indexOfKey(names, text.read(json) ?? '')];
  if (!found) json.fail('unknown', 'the name of a clip of the character, or # and its index');
  return found;
}

function readClip(json: JsonValue, character: Character): ClipParts | undefined {
  const read = readFields(plainFields, json, ['channels', 'unread']);
  if (!read) return undefined;
  const { file = '', name = 'Clip', start = 0, end = start, fps = 30 } = read;
  if (end < start) {
    json.member('end').fail('range', 'an end that is not before the start');
    return undefined;
  }
  const unread = json.record('a clip')?.get('unread');
  return {
    file,
    name,
    start,
    end,
    fps,
    channels: readChannels(json.member('channels'), character),
    ...(unread && { unread: unread.list(mostChannels, 'a list of channels')?.map(valueOf) ?? [] }),
  };
}

function readChannels(json: JsonValue, character: Character): ClipParts['channels'] {
  const taken = new Set<string>();
  const items = json.list(mostChannels, `a list of at most ${mostChannels} channels`) ?? [];
  return items.flatMap((item) => {
    const channel = readChannel(item, character);
    if (!channel?.target) return channel ?? [];
    const key = channelKey(channel.target);
    if (!taken.has(key)) {
      taken.add(key);
      return channel;
    }
    item.member('target').fail('duplicate', 'one channel for each value');
    return [];
  });
}

function valueOf({ value }: JsonValue): unknown {
  return value;
}
