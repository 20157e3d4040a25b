import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { readMotionText } from '../../../src/formats/motion/read-motion.ts';
import { channelNamed, channelsOfMotion } from '../../../src/formats/motion/sampled-channels.ts';

const page = readFileSync(new URL('../../../docs/formats/motion.md', import.meta.url), 'utf8');

it('reads the example of the documentation without a message, and every name of a channel in it', () => {
  const [, example] = /```json\n(.*?)```/s.exec(page)!;
  const { value, diagnostics } = readMotionText('m.json', example!);
  expect(diagnostics).toEqual([]);
  const channels = channelsOfMotion(value!);
  const rows = /sinew sample` needs.*?\n\n(\|.*?)\n\n/s.exec(page)![1]!.split('\n').slice(2, 6);
  const named = rows.map((row) => Array.from(row.matchAll(/`(.*?)`/g), ([, name]) => name!));
  expect(named.flat()).toHaveLength(8);
  named.forEach((names, at) => {
    for (const name of names) expect(channelNamed(channels, name), name).toBe(channels[at]);
  });
});
