import { describe, expect, it } from 'vitest';
import { readAnim } from '../../../src/formats/cse169/anim.ts';
import { legAnim } from '../../support/cse169-files.ts';
import { shown } from '../../support/diagnose.ts';
import { bytesOf } from '../../support/files.ts';

function read(content: string) {
  const { value, diagnostics } = readAnim('a.anim', bytesOf(content));
  return { value, messages: shown(diagnostics) };
}

const channel = 'channel { extrapolate cycle linear keys 1 { 0 1 flat 2 } }';

describe('readAnim', () => {
  it('reads range, channels, rules and keys, numbers glued to "channel" or not', () => {
    const { value, messages } = read(legAnim);
    expect(messages).toEqual([]);
    expect(value).toMatchObject({ name: 'a', start: 0, end: 2 });
    expect(value!.channels).toHaveLength(12);
    expect(value!.channels[2]).toEqual({
      target: null,
      before: 'bounce',
      after: 'bounce',
      keys: [
        { time: 0, value: 0, tangentIn: 13.7, tangentOut: -0.22 },
        { time: 1.5, value: 1, tangentIn: 'flat', tangentOut: 'flat' },
      ],
    });
  });

  it.each(['\r', '\r\r\n'])('reads lines that end with %j', (end) => {
    expect(read(legAnim.replaceAll('\n', end)).value).toEqual(read(legAnim).value);
  });

  it.each(['keys 0 { }', 'extrapolate cycle cycle'])(
    'tells of channels without keys, once: %j',
    (none) => {
      const { value, messages } = read(
        `animation {\n${channel} channel {\n${none}\n} channel { } }`,
      );
      expect(value!.channels.map(({ keys }) => keys.length)).toEqual([1, 0, 0]);
      expect(messages).toHaveLength(1);
      expect(messages[0]).toMatch(
        /^warning: a\.anim:[34]:\d+: expected at least one key, found "none" \[anim\/empty\]; the channel is 0/,
      );
    },
  );

  it('plays all keys where there is no range, and is constant where there is no rule', () => {
    const { value } = read('animation { channel { keys 2 { -1 0 flat flat 3 0 flat flat } } }');
    expect(value).toMatchObject({ start: -1, end: 3 });
    expect(value!.channels[0]).toMatchObject({ before: 'constant', after: 'constant' });
  });

  it.each([
    [
      `animation { numchannels 2 ${channel} }`,
      ': expected 2 channels, as the file says, found "1" [anim/count]; those that there are are used',
    ],
    [
      `animation { range 2 1 ${channel} }`,
      ': expected a range with its start first, found "2 1" [anim/order]; they are swapped',
    ],
    [
      `animation { fps 30 ${channel} }`,
      ':1:13: expected a word of this format, found "fps" [anim/unknown]; it is skipped, with its numbers or its block',
    ],
    [
      `animation { ${channel} } end`,
      ':1:74: expected nothing after the animation, found "end" [anim/trailing]; it is skipped',
    ],
  ])('reads %j and warns', (text, message) => {
    const { value, messages } = read(text);
    expect(messages).toEqual([`warning: a.anim${message}`]);
    expect(value?.channels).toHaveLength(1);
  });

  it('sorts keys by time, and takes the last of several at one time', () => {
    const { value, messages } = read(
      'animation { channel { keys 3 { 1 5 flat flat 0 2 flat flat 1 6 flat flat } } }',
    );
    expect(value!.channels[0]!.keys.map(({ time, value: at }) => [time, at])).toEqual([
      [0, 2],
      [1, 6],
    ]);
    expect(messages).toHaveLength(1);
  });

  it.each([
    ['range 0 1', '1:1: expected "animation", found "range" [anim/token]'],
    ['animation { }', ': expected at least one channel, found "none" [anim/empty]'],
    [
      'animation { channel {',
      '1:22: expected "}" for the channel, found "the end of the file" [anim/end]',
    ],
    [
      'animation { channel { extrapolate cycle forever } }',
      '1:41: expected constant, linear, cycle, cycle_offset or bounce, found "forever" [anim/token]',
    ],
    [
      'animation { channel { keys 1 { 0 1 smoth flat } } }',
      '1:36: expected a tangent: flat, linear, smooth or a number, found "smoth" [anim/token]',
    ],
    [
      'animation { channel { keys 2 { 0 1 flat flat } } }',
      '1:46: expected 2 rows of keys, as the file says, found "1" [anim/count]',
    ],
    [
      'animation { channel { keys 1 { 0 nan flat flat } } }',
      '1:34: expected a number for the value of a key, found "nan" [anim/number]',
    ],
    [
      'animation { channel { keys 9999 { } } }',
      '1:28: expected at most 1 keys, for the file has no room for more, found "9999" [anim/count]',
    ],
  ])('refuses %j', (text, message) => {
    expect(read(text)).toEqual({
      value: undefined,
      messages: [
        `error: a.anim${message.startsWith(':') ? '' : ':'}${message}; the clip is not used`,
      ],
    });
  });
});
