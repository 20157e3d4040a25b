import { afterEach, expect, it, vi } from 'vitest';
import { onceAFrame } from '../../src/ui/once-a-frame.ts';

afterEach(() => vi.unstubAllGlobals());

it('runs at once, then once a frame with the last value, and rests without a new one', () => {
  let waiting: (() => void)[] = [];
  vi.stubGlobal('requestAnimationFrame', (run: () => void) => waiting.push(run));
  const frame = (): void => {
    const now = waiting;
    waiting = [];
    for (const run of now) run();
  };
  const seen: number[] = [];
  const offer = onceAFrame((value: number) => seen.push(value));
  offer(1);
  expect(seen).toEqual([1]);
  for (const value of [2, 3, 4]) offer(value);
  expect(seen, 'one run a frame').toEqual([1]);
  frame();
  expect(seen).toEqual([1, 4]);
  frame();
  frame();
  expect(waiting, 'no frame is asked for while nothing comes').toEqual([]);
  offer(5);
  expect(seen).toEqual([1, 4, 5]);
});
