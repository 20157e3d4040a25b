import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { contexts, keyName, withCommand } from '../../src/ui/keymap.ts';

const bindings = [...contexts.flatMap(({ keys }) => keys), ...withCommand];

describe('the keymap', () => {
  it('binds no key twice in a context', () => {
    for (const context of [...contexts.map(({ keys }) => keys), withCommand]) {
      const names = context.map(keyName);
      expect(new Set(names).size).toBe(names.length);
    }
  });

  it('is told in docs/keys.md, key by key with what it does', () => {
    const rows = rowsOf('docs/keys.md', '# Keys and pointer');
    for (const binding of bindings) {
      expect(rows).toContainEqual([`\`${keyName(binding)}\``, binding.label]);
    }
  });

  it('has every key of the README', () => {
    const section = rowsOf('README.md', '## Keys');
    const told = section.flatMap(([key]) => [...key!.matchAll(/`(.+?)`/g)].map(([, name]) => name));
    expect(told.length).toBeGreaterThan(5);
    for (const name of told) expect(bindings.map(keyName)).toContain(name);
  });
});

/** The cells of each row of the tables under a heading, up to the next of its level. */
function rowsOf(file: string, heading: string): string[][] {
  const page = readFileSync(new URL(`../../${file}`, import.meta.url), 'utf8');
  const level = heading.slice(0, heading.indexOf(' ') + 1);
  const [section] = page.slice(page.indexOf(heading) + level.length).split(`\n${level}`);
  const rows = section!.split('\n').filter((line) => line.startsWith('| '));
  return rows.map((line) =>
    line
      .slice(2, -2)
      .split(' | ')
      .map((cell) => cell.trim()),
  );
}
