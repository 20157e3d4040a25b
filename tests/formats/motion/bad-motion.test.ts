import { describe, expect, it } from 'vitest';
import { bindMotion } from '../../../src/formats/motion/bind-motion.ts';
import { readMotionText } from '../../../src/formats/motion/read-motion.ts';
import { shown } from '../../support/diagnose.ts';
import { mover } from './mover.ts';

/** What a text leaves: how many channels move something and how many are kept; null if nothing. */
type Left = readonly [used: number, kept: number] | null;

const elbow = '"target": {"joint": "elbow", "value": "rx"}';
const used = `{${elbow}, "keys": [[0, 1]]}`;
const unused = 'the motion is not used';
const kept = 'the channel is not used; it is kept for saving';

/** A motion with these channels, each on a line of its own, from line 2. */
function motion(...channels: readonly string[]): string {
  return `{"channels": [\n${channels.join(',\n')}\n]}`;
}

/** A motion whose second channel is sound. */
const beside = (channel: string): string =>
  motion(channel, '{"target": {"morph": "smile"}, "keys": [[0, 1]]}');
const keysOf = (keys: string): string => beside(`{${elbow}, "keys": ${keys}}`);

const rows: readonly (readonly [title: string, text: string, message: string, left: Left])[] = [
  [
    'no JSON',
    '{"channels": [',
    `error: m.json:1:15 (channels[0]): expected a value, found "the end of the text" [motion/json]; ${unused}`,
    null,
  ],
  [
    'NaN',
    keysOf('[[0, NaN]]'),
    `error: m.json:2:60 (channels[0].keys[0][1]): expected a value, found "NaN" [motion/json]; ${unused}`,
    null,
  ],
  [
    '-Infinity',
    keysOf('[[0, -Infinity]]'),
    `error: m.json:2:60 (channels[0].keys[0][1]): expected a value, found "-Infinity" [motion/json]; ${unused}`,
    null,
  ],
  [
    'a list',
    '[]',
    `error: m.json:1:1: expected an object with "channels", found "[]" [motion/json]; ${unused}`,
    null,
  ],
  [
    'no channels',
    '{}',
    `error: m.json:1:1: expected an object with "channels", found "{}" [motion/json]; ${unused}`,
    null,
  ],
  [
    'channels that are no list',
    '{"channels": {}}',
    `error: m.json:1:14 (channels): expected "channels" to be a list, found "{}" [motion/json]; ${unused}`,
    null,
  ],
  [
    'a greater version',
    '{"version": 2, "channels": []}',
    `error: m.json:1:13 (version): expected "version" to be 1 (a newer Sinew wrote this), found "2" [motion/version]; ${unused}`,
    null,
  ],
  [
    '0 frames a second',
    `{"fps": 0, "channels": [${used}]}`,
    'warning: m.json:1:9 (fps): expected frames a second from 1 to 1000, found "0" [motion/range]; 30 are used',
    [1, 0],
  ],
  [
    'fewer than 0 frames a second',
    `{"fps": -24, "channels": [${used}]}`,
    'warning: m.json:1:9 (fps): expected frames a second from 1 to 1000, found "-24" [motion/range]; 30 are used',
    [1, 0],
  ],
  [
    'a word for the rate',
    `{"fps": "24", "channels": [${used}]}`,
    'warning: m.json:1:9 (fps): expected frames a second from 1 to 1000, found ""24"" [motion/json]; 30 are used',
    [1, 0],
  ],
  [
    'a range backwards',
    `{"range": [2, 0], "channels": [${used}]}`,
    'warning: m.json:1:11 (range): expected a range with its start first, found "[2,0]" [motion/order]; they are swapped',
    [1, 0],
  ],
  [
    'a range of one number',
    `{"range": [2], "channels": [${used}]}`,
    'warning: m.json:1:11 (range): expected a range as [start, end], found "[2]" [motion/json]; the range of the keys is used',
    [1, 0],
  ],
  [
    'an unknown field',
    `{"speed": 2, "channels": [${used}]}`,
    'warning: m.json:1:11 (speed): expected one of version, fps, range, channels, found "speed" [motion/unknown]; it is left out',
    [1, 0],
  ],
  [
    'a channel that is a number',
    beside('5'),
    `error: m.json:2:1 (channels[0]): expected a channel as an object, found "5" [motion/json]; ${kept}`,
    [1, 1],
  ],
  [
    'no target',
    beside('{"keys": []}'),
    `error: m.json:2:1 (channels[0]): expected a channel with a "target", found "none" [motion/json]; ${kept}`,
    [1, 1],
  ],
  [
    'an unknown target',
    beside('{"target": {"light": "sun"}, "keys": [[0, 1]]}'),
    `warning: m.json:2:12 (channels[0].target): expected a target that Sinew knows, found "light" [motion/unknown]; ${kept}`,
    [1, 1],
  ],
  [
    'a target without fields',
    beside('{"target": {}, "keys": [[0, 1]]}'),
    `warning: m.json:2:12 (channels[0].target): expected a target that Sinew knows, found "{}" [motion/unknown]; ${kept}`,
    [1, 1],
  ],
  [
    'a name that is a number',
    beside('{"target": {"joint": 3, "value": "rx"}, "keys": []}'),
    `error: m.json:2:22 (channels[0].target.joint): expected the name of a joint, or # and its index, found "3" [motion/json]; ${kept}`,
    [1, 1],
  ],
  [
    'an unknown joint',
    beside('{"target": {"joint": "Elbow", "value": "rx"}, "keys": [[0, 1]]}'),
    `error: m.json:2:22 (channels[0].target.joint): expected the name of a joint, or # and its index ("elbow"?), found "Elbow" [motion/unknown-joint]; ${kept}`,
    [1, 1],
  ],
  [
    'an index past the end',
    beside('{"target": {"joint": "#9", "value": "rx"}, "keys": [[0, 1]]}'),
    `error: m.json:2:22 (channels[0].target.joint): expected a joint from #0 to #3, found "#9" [motion/unknown-joint]; ${kept}`,
    [1, 1],
  ],
  [
    'an unknown morph',
    beside('{"target": {"morph": "frown"}, "keys": [[0, 1]]}'),
    `error: m.json:2:22 (channels[0].target.morph): expected the name of a morph, or # and its index, found "frown" [motion/unknown-morph]; ${kept}`,
    [1, 1],
  ],
  [
    'an unknown pin',
    beside('{"target": {"pin": "hand", "value": "x"}, "keys": [[0, 1]]}'),
    `error: m.json:2:20 (channels[0].target.pin): expected the name of a joint, or # and its index, found "hand" [motion/unknown-joint]; ${kept}`,
    [1, 1],
  ],
  [
    'an unknown value',
    beside('{"target": {"joint": "elbow", "value": "sx"}, "keys": [[0, 1]]}'),
    `error: m.json:2:40 (channels[0].target.value): expected one of tx, ty, tz, rx, ry, rz, found ""sx"" [motion/token]; ${kept}`,
    [1, 1],
  ],
  [
    'an angle of a ball',
    beside('{"target": {"joint": "neck", "value": "rx"}, "keys": [[0, 1]]}'),
    `error: m.json:2:39 (channels[0].target.value): expected "rotation" for "neck", which turns as a ball, found "rx" [motion/token]; ${kept}`,
    [1, 1],
  ],
  [
    'an axis that is not there',
    beside('{"target": {"joint": "wrist", "value": "ry"}, "keys": [[0, 1]]}'),
    'warning: m.json:2:40 (channels[0].target.value): expected no ry for "wrist", which does not turn about y, found "ry" [motion/ignored]; the channel moves nothing; it is kept for saving',
    [1, 1],
  ],
  [
    'a rotation of a hinge',
    beside('{"target": {"joint": "wrist", "rotation": "slerp"}, "keys": [[0, [0, 0, 0, 1]]]}'),
    'warning: m.json:2:43 (channels[0].target.rotation): expected no rotation for "wrist", which does not turn about every axis, found "slerp" [motion/ignored]; the channel moves nothing; it is kept for saving',
    [1, 1],
  ],
  [
    'another curve of rotations',
    beside('{"target": {"joint": "neck", "rotation": "nlerp"}, "keys": [[0, [0, 0, 0, 1]]]}'),
    `error: m.json:2:42 (channels[0].target.rotation): expected one of slerp, squad, found ""nlerp"" [motion/token]; ${kept}`,
    [1, 1],
  ],
  [
    'no keys',
    beside(`{${elbow}}`),
    `error: m.json:2:1 (channels[0]): expected a channel with "keys", found "none" [motion/json]; ${kept}`,
    [1, 1],
  ],
  [
    'an empty list of keys',
    keysOf('[]'),
    'warning: m.json:2:55 (channels[0].keys): expected at least one key, found "none" [motion/empty]; the value is 0 at all times',
    [2, 0],
  ],
  [
    'a key of one number',
    keysOf('[[0]]'),
    `error: m.json:2:56 (channels[0].keys[0]): expected a key as [time, value] or [time, value, in, out], found "[0]" [motion/json]; ${kept}`,
    [1, 1],
  ],
  [
    'a time that is a word',
    keysOf('[["0", 1]]'),
    `error: m.json:2:57 (channels[0].keys[0][0]): expected a time in seconds, found ""0"" [motion/json]; ${kept}`,
    [1, 1],
  ],
  [
    'a value past all numbers',
    keysOf('[[0, 1e999]]'),
    `error: m.json:2:60 (channels[0].keys[0][1]): expected a value within ±1e18, found "Infinity" [motion/range]; ${kept}`,
    [1, 1],
  ],
  [
    'a quaternion for a number',
    keysOf('[[0, [0, 0, 0, 1]]]'),
    `error: m.json:2:60 (channels[0].keys[0][1]): expected a value, found "[0,0,0,1]" [motion/json]; ${kept}`,
    [1, 1],
  ],
  [
    'an unknown tangent',
    keysOf('[[0, 1, "step", "auto"]]'),
    `error: m.json:2:63 (channels[0].keys[0][2]): expected a slope, one of flat, linear, smooth, auto, stepped, or ["tcb", T, C, B], found ""step"" [motion/token]; ${kept}`,
    [1, 1],
  ],
  [
    'a TCB of two numbers',
    keysOf('[[0, 1, "auto", ["tcb", 0, 0]]]'),
    `error: m.json:2:71 (channels[0].keys[0][3]): expected a slope, one of flat, linear, smooth, auto, stepped, or ["tcb", T, C, B], found "["tcb",0,0]" [motion/token]; ${kept}`,
    [1, 1],
  ],
  [
    'keys in another order',
    keysOf('[[1, 1], [0, 2]]'),
    'warning: m.json:2:64 (channels[0].keys[1]): expected keys at rising times, found "0 after 1" [motion/order]; they are sorted',
    [2, 0],
  ],
  [
    'two keys at one time',
    keysOf('[[0, 1], [0.00005, 2]]'),
    'warning: m.json:2:64 (channels[0].keys[1]): expected one key at a time, found "1 at the time of another" [motion/duplicate]; the last one counts',
    [2, 0],
  ],
  [
    'a rotation without length',
    beside('{"target": {"joint": "neck", "rotation": "slerp"}, "keys": [[0, [0, 0, 0, 0]]]}'),
    `error: m.json:2:65 (channels[0].keys[0][1]): expected a quaternion with a length, found "[0,0,0,0]" [motion/range]; ${kept}`,
    [1, 1],
  ],
  [
    'tangents of a rotation',
    beside('{"target": {"joint": "neck", "rotation": "slerp"}, "keys": [[0, [0, 0, 0, 1], 0, 0]]}'),
    `error: m.json:2:61 (channels[0].keys[0]): expected a key as [time, [x, y, z, w]], found "[0,[0,0,0,1],0,0]" [motion/json]; ${kept}`,
    [1, 1],
  ],
  [
    'one word of extrapolation',
    beside(`{${elbow}, "extrapolate": "cycle", "keys": []}`),
    `error: m.json:2:62 (channels[0].extrapolate): expected "extrapolate" with two words, for before and after the keys, found ""cycle"" [motion/json]; ${kept}`,
    [1, 1],
  ],
  [
    'an unknown extrapolation',
    beside(`{${elbow}, "extrapolate": ["cycle", "loop"], "keys": []}`),
    `error: m.json:2:72 (channels[0].extrapolate[1]): expected one of constant, linear, cycle, cycle_offset, bounce, found ""loop"" [motion/token]; ${kept}`,
    [1, 1],
  ],
  [
    'two channels for one value',
    motion(used, used),
    'warning: m.json:2:12 (channels[0].target): expected one channel for each target, found "elbow.rx" [motion/duplicate]; the last one counts',
    [1, 0],
  ],
  [
    'two names of one value',
    motion(used, used.replace('elbow', '#1')),
    'warning: m.json:3:12 (channels[1].target): expected one channel for each target, found "elbow.rx" [motion/duplicate]; the last one counts',
    [1, 0],
  ],
  [
    'an angle and a rotation of one joint',
    motion(used, '{"target": {"joint": "elbow", "rotation": "slerp"}, "keys": []}').replace(
      '[]',
      '[[0, [0, 0, 0, 1]]]',
    ),
    'warning: m.json:2:12 (channels[0].target): expected angles or a rotation of a joint, found "elbow.rx" [motion/duplicate]; its rotation counts',
    [1, 0],
  ],
  [
    'a field that no target of its kind has',
    motion('{"target": {"joint": "elbow", "value": "rx", "side": "left"}, "keys": [[0, 1]]}'),
    'warning: m.json:2:54 (channels[0].target.side): expected one of joint, value, found "side" [motion/unknown]; it is left out',
    [1, 0],
  ],
];

describe('a bad MOTION.json', () => {
  it.each(rows)('%s', (_, text, message, left) => {
    const read = readMotionText('m.json', text);
    const bound = read.value && bindMotion(read.value, mover);
    expect(shown([...read.diagnostics, ...(bound?.diagnostics ?? [])])).toEqual([message]);
    const clip = bound?.value;
    expect(clip ? [clip.channels.length, clip.unread?.length ?? 0] : null).toEqual(left);
  });

  it('keeps the motion usable however many of its channels are wrong', () => {
    const wrong = Array.from({ length: 300 }, () => '{"target": {"joint": 5}}');
    const { value, diagnostics } = readMotionText('m.json', motion(...wrong, used));
    expect(value!.channels).toHaveLength(1);
    expect(diagnostics).toHaveLength(101);
  });
});
