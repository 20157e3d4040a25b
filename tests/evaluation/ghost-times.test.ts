import { expect, it } from 'vitest';
import { MotionView } from '../../src/document/motion-view.ts';
import { ghostTimes } from '../../src/evaluation/ghost-times.ts';

const key = (time: number) => ({ time, value: 0, tangentIn: 'auto', tangentOut: 'auto' }) as const;
const channel = (...times: number[]) =>
  ({ target: null, before: 'constant', after: 'constant', keys: times.map(key) }) as const;
const clip = {
  ...{ file: '', name: 'a', start: 0, end: 2, fps: 10 },
  channels: [channel(0, 0.5, 1), channel(0.25, 1, 1.75)],
};
const plain = new MotionView().ghosts.value;

it('stand so many frames apart on both sides, the farthest first', () => {
  const settings = { ...plain, before: 2, after: 1, frames: 4 };
  const times = ghostTimes(clip, 1, settings, 'once');
  expect(times.map(({ rank }) => rank)).toEqual([-2, -1, 1]);
  const expected = [0.2, 0.6, 1.4];
  times.forEach(({ time }, at) => expect(time).toBeCloseTo(expected[at]!));
});

it('stand outside the range only where the clip goes on', () => {
  const settings = { ...plain, before: 2, after: 0, frames: 5 };
  expect(ghostTimes(clip, 0.6, settings, 'once').map(({ rank }) => rank)).toEqual([-1]);
  expect(ghostTimes(clip, 0.6, settings, 'loop').map(({ rank }) => rank)).toEqual([-2, -1]);
});

it('stand at the keys of all channels, each time once', () => {
  const settings = { ...plain, at: 'keys' as const, before: 2, after: 2 };
  const times = ghostTimes(clip, 0.5, settings, 'loop');
  expect(new Set(times)).toEqual(
    new Set([
      { time: 0.25, rank: -1 },
      { time: 0, rank: -2 },
      { time: 1, rank: 1 },
      { time: 1.75, rank: 2 },
    ]),
  );
});
