import { parseArgs } from 'node:util';
import { channelFor, evaluateChannel } from '../core/motion/channel.ts';
import { readAnim } from '../formats/cse169/anim.ts';
import { baseName } from '../formats/file-entry.ts';
import type { Command } from './command.ts';
import { printDiagnostics, readFiles } from './files.ts';
import { parseWords } from './parse-words.ts';
import { UsageError } from './usage-error.ts';

/**
 * `sample CLIP.anim --channel N --times t0,t1,…` prints values of a channel. Channels count from 0,
 * like joints: 0 to 2 are the root's translation, followed by three angles per joint.
 */
export const sample: Command = {
  name: 'sample',
  usage: 'sample CLIP.anim --channel N --times t0,t1,… [--json]',
  summary:
    "Prints the values of one of a clip's channels, counted from 0, at the given times in seconds.",
  async run(words) {
    const { file, channel, times, json } = parseOptions(words);
    const { files, diagnostics } = readFiles([file]);
    const entry = files[0];
    const parsed = entry && readAnim(baseName(entry.path), await entry.bytes());
    printDiagnostics([...diagnostics, ...(parsed?.diagnostics ?? [])]);
    if (!parsed?.value) return 1;
    const { channels } = parsed.value;
    const parts = channels[channel];
    if (!parts) {
      throw new UsageError(`expected --channel from 0 to ${channels.length - 1}, found ${channel}`);
    }
    const compiled = channelFor(parts);
    const values = times.map((time) => evaluateChannel(compiled, time));
    if (json) console.log(JSON.stringify({ channel, times, values }, null, 2));
    else times.forEach((time, index) => console.log(`${time}\t${values[index]!}`));
    return 0;
  },
};

function parseOptions(words: readonly string[]) {
  const { values, positionals } = parseWords(() =>
    parseArgs({
      args: joinTimes(words),
      options: {
        channel: { type: 'string' },
        times: { type: 'string' },
        json: { type: 'boolean', default: false },
      },
      allowPositionals: true,
    }),
  );
  const [file] = positionals;
  if (file === undefined || positionals.length > 1) throw new UsageError('expected one .anim file');
  const channel = /^\d+$/.test(values.channel ?? '') ? Number(values.channel) : NaN;
  if (Number.isNaN(channel)) {
    throw new UsageError('expected --channel with a whole number, 0 or more');
  }
  const times = (values.times ?? '').split(',').map((word) => (word.trim() ? Number(word) : NaN));
  if (!times.every(Number.isFinite)) {
    throw new UsageError('expected --times with seconds and commas between them');
  }
  return { file, channel, times, json: values.json };
}

/** Joins `--times` and its value, because `parseArgs` would take `-1,0` for another option. */
function joinTimes(words: readonly string[]): string[] {
  const at = words.indexOf('--times');
  if (at === -1 || at + 1 >= words.length) return [...words];
  return [...words.slice(0, at), `--times=${words[at + 1]!}`, ...words.slice(at + 2)];
}
