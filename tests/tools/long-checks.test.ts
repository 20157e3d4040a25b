import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { expect, it } from 'vitest';
import { root } from '../../tools/commands.mjs';
import { chosenChecks, longChecks } from '../../tools/long-checks.mjs';

it('accepts a name and options, and defaults for the other options', () => {
  const [soak] = chosenChecks(['soak', '--seed', '3,4', '--minutes=0.5']);
  expect(soak).toMatchObject({
    check: { name: 'soak' },
    environment: { SOAK_SEEDS: '3,4', SOAK_MINUTES: '0.5' },
  });
  expect(chosenChecks(['soak'])[0]!.environment).toEqual({
    SOAK_SEEDS: '1,2,3,4,5',
    SOAK_MINUTES: '10',
  });
  expect(chosenChecks([])).toHaveLength(longChecks.length);
});

it.each([['sock'], ['soak', '--sead', '3'], ['soak', '--seed'], ['soak', '--minutes', 'ten']])(
  'refuses %s %s %s, and says what there is',
  (...words) => {
    expect(() => chosenChecks(words)).toThrow(/(no long check|not understood)[^]*--minutes 10/);
  },
);

it('has a test for each check, which reads each of its variables', () => {
  for (const { tests, reads, options } of longChecks) {
    expect(existsSync(path.join(root, tests))).toBe(true);
    const file = path.join(root, reads);
    expect(existsSync(file)).toBe(true);
    for (const { variable } of Object.values(options)) {
      expect(readFileSync(file, 'utf8')).toContain(`'${variable}'`);
    }
  }
});
