import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { ClipParts } from '../../../src/core/motion/clip-parts.ts';
import { decodeText } from '../../../src/formats/text/decode-text.ts';
import { readBoundMotion } from '../../../src/formats/motion/read-bound-motion.ts';
import { writeMotion } from '../../../src/formats/motion/write-motion.ts';
import { mover } from './mover.ts';
import { clips } from './random-clips.ts';

function writtenOf(clip: ClipParts): Uint8Array {
  const { files, losses } = writeMotion(clip, mover);
  expect(losses).toEqual([]);
  return files[0]!.bytes;
}

describe('writing and reading a motion', () => {
  it('gives the same clip, bit by bit, with every target, tangent and extrapolation', () => {
    fc.assert(
      fc.property(clips, (clip) => {
        const { value } = readBoundMotion(clip.file, writtenOf(clip), mover);
        expect(value).toStrictEqual(clip);
      }),
      { numRuns: 300 },
    );
  });

  it('writes names where they are clear, and a key a line', () => {
    const key = { time: 0, value: -0, tangentIn: 'auto', tangentOut: 'auto' } as const;
    const tcb = { tcb: [0.5, -1, 0] } as const;
    const rules = { before: 'constant', after: 'cycle' } as const;
    const clip: ClipParts = {
      file: 'a.json',
      name: 'wave',
      start: 0,
      end: 2,
      fps: 24,
      channels: [
        { target: { of: 'morph', morph: 0 }, ...rules, keys: [key] },
        {
          target: { of: 'morph', morph: 1 },
          before: 'constant',
          after: 'constant',
          keys: [key, { ...key, time: 1, tangentIn: 'flat', tangentOut: tcb }],
        },
      ],
      unread: [{ target: { light: 'sun' } }],
    };
    expect(decodeText(writtenOf(clip))).toBe(`{
  "version": 1,
  "fps": 24,
  "range": [0, 2],
  "channels": [
    {"target": {"morph": "smile"}, "extrapolate": ["constant", "cycle"], "keys": [
      [0, -0]
    ]},
    {"target": {"morph": "#1"}, "keys": [
      [0, -0],
      [1, -0, "flat", ["tcb", 0.5, -1, 0]]
    ]},
    {"target":{"light":"sun"}}
  ]
}
`);
  });

  it('says how many channels move nothing that has a name', () => {
    const channel = { target: null, before: 'constant', after: 'constant', keys: [] } as const;
    const clip = { file: 'a', name: 'a', start: 0, end: 1, fps: 30, channels: [channel] };
    const { losses } = writeMotion(clip, mover);
    expect(losses.map(({ found, effect }) => [found, effect])).toEqual([
      ['1 others', 'they are left out'],
    ]);
  });
});
