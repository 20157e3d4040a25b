import { describe, expect, it } from 'vitest';
import { goals } from '../../bench/goals.ts';
import { whatGotWorse } from '../../bench/harness/compare.ts';
import { timesFaster, timesSlower } from '../../bench/harness/group.ts';
import { type Contender, measure } from '../../bench/harness/measure.ts';
import { spreadOf } from '../../bench/harness/statistics.ts';
import { rowOf } from '../../bench/harness/table.ts';
import { limits } from '../../bench/limits.ts';
import { parseWords } from '../../bench/options.ts';

const wallOf = (...times: readonly number[]) => times.map((wall) => ({ wall }));

it('the median and the quartiles are those of the sorted values', () => {
  expect(spreadOf([5, 1, 4, 2, 3])).toEqual({ lower: 2, median: 3, upper: 4 });
  expect(spreadOf([1, 2])).toEqual({ lower: 1.25, median: 1.5, upper: 1.75 });
});

it('a ratio compares the samples of the same round', () => {
  // The machine was ten times slower in the second round, for both.
  const samples = { fast: wallOf(1, 10, 2), slow: wallOf(3, 30, 6) };
  expect(timesFaster(samples, 'fast', 'slow')).toEqual({ value: 3, lower: 3, upper: 3 });
  expect(timesSlower(samples, 'slow', 'fast').value).toBe(3);
});

describe('measure', () => {
  const record = async (rounds: number): Promise<string> => {
    const order: string[] = [];
    const contender = (id: string): Contender => ({
      id,
      sample: () => {
        order.push(id);
        return { wall: order.length };
      },
    });
    const samples = await measure(['a', 'b', 'c'].map(contender), rounds);
    for (const taken of Object.values(samples)) expect(taken).toHaveLength(rounds);
    return order.join('');
  };

  it('runs every contender once in each round, in an order that differs and is repeatable', async () => {
    const order = await record(8);
    const rounds = order.match(/.../g)!;
    expect(rounds).toHaveLength(9); // the first one is not counted
    for (const round of rounds) expect(Array.from(round).sort().join('')).toBe('abc');
    expect(new Set(rounds).size).toBeGreaterThan(2);
    expect(await record(8)).toBe(order);
  });
});

describe('whatGotWorse', () => {
  const found = (value: number, id: string) => ({
    values: { [id]: { value } },
    samples: {},
    counts: {},
  });

  it.each([
    ['obj', 10, 8, false],
    ['obj', 10, 7, true],
    ['frame-still-13k', 1, 1.3, false],
    ['frame-still-13k', 1, 1.5, true],
    ['first-scripts', 50, 52, false],
    ['first-scripts', 50, 53, true],
  ])('compares %s: from %d to %d is worse: %s', (id, before, now, isWorse) => {
    expect(whatGotWorse(found(now, id), found(before, id)).length > 0).toBe(isWorse);
  });
});

it('a row of the table says whether must and aim are reached', () => {
  const goal = goals.find(({ id }) => id === 'obj')!;
  expect(rowOf(goal, undefined)).toContain('not measured');
  expect(rowOf(goal, { value: 12.1 })).toContain('aim reached');
  expect(rowOf(goal, { value: 8 })).toContain('must reached');
  expect(rowOf(goal, { value: 6.9 })).toContain('must missed');
});

it('every goal has an id of its own, and every limit belongs to one', () => {
  const ids = goals.map(({ id }) => id);
  expect(new Set(ids).size).toBe(ids.length);
  expect(Object.keys(limits).filter((id) => !ids.includes(id))).toEqual([]);
});

it('options are understood or refused', () => {
  expect(parseWords(['--long', '--check', '--only=frames,readers'])).toEqual({
    ...{ long: true, check: true, only: ['frames', 'readers'], rounds: 15 },
    ...{ save: null, testSeconds: null },
  });
  expect(parseWords(['--save=12-faces', '--test-seconds=260'])).toMatchObject({
    ...{ rounds: 9, save: '12-faces', testSeconds: 260 },
  });
  const partial = ['--only=frames', '--save=12-faces'];
  const others = [['--lnog'], ['--only=frame'], ['--rounds=none'], ['--save'], ['frames']];
  for (const words of [partial, ...others]) {
    expect(() => parseWords(words), words.join()).toThrow(/not understood.*--only=GROUP/s);
  }
});
