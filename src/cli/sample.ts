import { parseArgs } from 'node:util';
import { printable } from '../core/diagnostics.ts';
import { channelNamed, type SampledChannel } from '../formats/motion/sampled-channels.ts';
import type { Command } from './command.ts';
import { printDiagnostics } from './files.ts';
import { joinValue, parseWords } from './parse-words.ts';
import { readChannels } from './read-motion-file.ts';
import { UsageError } from './usage-error.ts';

/**
 * `sample MOTION.json|CLIP.anim --channel N|NAME --times t0,t1,…` prints values of a channel.
 * Channels count from 0 in the order of the file; in an `.anim`, 0 to 2 are the root's translation,
 * followed by three angles per joint.
 */
export const sample: Command = {
  name: 'sample',
  usage: 'sample MOTION.json|CLIP.anim --channel N|NAME --times t0,t1,… [--json]',
  summary:
    "Prints the values of one of a motion's channels at the given times in seconds. A channel is its number in the file, counted from 0 with those that cannot be used, or its name: Right elbow.rx, Neck.rotation, smile or morph.smile, Left foot.x or pin.Left foot.x; in an .anim #0.tx or #3.rx, as docs/formats/motion.md says. A rotation is printed as x,y,z,w.",
  async run(words) {
    const { file, channel, times, json } = parseOptions(words);
    const { value: channels, diagnostics } = await readChannels(file);
    printDiagnostics(diagnostics);
    if (!channels) return 1;
    const sampled =
      typeof channel === 'number' ? channels[channel] : channelNamed(channels, channel);
    if (!sampled) return tellUnknown(channel, channels);
    const values = times.map((time) => sampled.valueAt(time));
    if (json) console.log(JSON.stringify({ channel, times, values }, null, 2));
    else times.forEach((time, index) => console.log(`${time}\t${String(values[index])}`));
    return 0;
  },
};

/** Names in a usage error; a clip may have thousands. */
const mostNames = 40;

/** Says that there is no such channel: the file is to blame for one that it has, otherwise the user. */
function tellUnknown(
  channel: number | string,
  channels: readonly (SampledChannel | undefined)[],
): number {
  const usable = channels.filter((each) => each !== undefined);
  const isOfFile = typeof channel === 'number' && channel < channels.length;
  if (!isOfFile && usable.length > 0) throw new UsageError(expectedChannel(channel, channels));
  if (isOfFile) console.error(`error: channel ${channel} cannot be used`);
  else if (channels.length > 0) console.error('error: no channel of the motion can be used');
  else console.error('error: the motion has no channels');
  return 1;
}

function expectedChannel(
  channel: number | string,
  channels: readonly (SampledChannel | undefined)[],
): string {
  const found = typeof channel === 'number' ? channel : `"${printable(channel, 80)}"`;
  const usable = channels.filter((each) => each !== undefined);
  const names = usable.slice(0, mostNames).map(({ names: [name] }) => printable(name!, 80));
  const more = usable.length - names.length;
  const list = `${names.join(', ')}${more > 0 ? ` and ${more} more` : ''}`;
  return `expected --channel from 0 to ${channels.length - 1} or a name, found ${found}; the channels are ${list}`;
}

function parseOptions(words: readonly string[]) {
  const { values, positionals } = parseWords(() =>
    parseArgs({
      args: joinValue(joinValue(words, '--times'), '--channel'),
      options: {
        channel: { type: 'string' },
        times: { type: 'string' },
        json: { type: 'boolean', default: false },
      },
      allowPositionals: true,
    }),
  );
  const [file] = positionals;
  if (file === undefined || positionals.length > 1) {
    throw new UsageError('expected one MOTION.json or .anim file');
  }
  const word = values.channel ?? '';
  if (word === '') throw new UsageError('expected --channel with a number, 0 or more, or a name');
  const channel = /^\d+$/.test(word) ? Number(word) : word;
  const times = (values.times ?? '').split(',').map((each) => (each.trim() ? Number(each) : NaN));
  if (!times.every(Number.isFinite)) {
    throw new UsageError('expected --times with seconds and commas between them');
  }
  return { file, channel, times, json: values.json };
}
