import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { contexts, keyName, withCommand } from '../../src/ui/keymap.ts';

describe('the keymap', () => {
  it('binds no key twice in a context', () => {
    for (const context of [...contexts.map(({ keys }) => keys), withCommand]) {
      const names = context.map(keyName);
      expect(new Set(names).size).toBe(names.length);
    }
  });

  it('is told in the README, key by key', () => {
    const readme = readFileSync(new URL('../../README.md', import.meta.url), 'utf8');
    const arrows = /^[←→↑↓]$/;
    for (const binding of [...contexts.flatMap(({ keys }) => keys), ...withCommand]) {
      const name = keyName(binding);
      if (!arrows.test(name)) expect(readme).toContain(`\`${name}\``);
    }
  });
});
