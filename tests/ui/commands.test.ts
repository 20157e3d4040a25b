import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { contexts, keyRows } from '../../src/ui/commands/contexts.ts';
import { commands } from '../../src/ui/commands/registry.ts';

const everyRow = contexts.flatMap(({ id }) => keyRows(id));

describe('the keymap', () => {
  it('binds no key twice in a context', () => {
    for (const { id } of contexts) {
      const names = keyRows(id).map(([name]) => name);
      expect(names.length).toBeGreaterThan(0);
      expect(new Set(names).size).toBe(names.length);
    }
  });

  it('has every key of every command', () => {
    const count = commands.reduce((sum, { keys }) => sum + (keys?.length ?? 0), 0);
    expect(everyRow).toHaveLength(count);
    expect(new Set(commands.map(({ id }) => id)).size).toBe(commands.length);
  });

  it('is listed in docs/keys.md, each key with its effect', () => {
    const rows = rowsOf('docs/keys.md', '# Keys and pointer');
    for (const [key, does] of everyRow) expect(rows).toContainEqual([`\`${key}\``, does]);
  });

  it('has every key of the README', () => {
    const section = rowsOf('README.md', '## Keys');
    const told = section.flatMap(([key]) => [...key!.matchAll(/`(.+?)`/g)].map(([, name]) => name));
    const names = everyRow.map(([key]) => key);
    expect(told.length).toBeGreaterThan(5);
    for (const name of told) expect(names).toContain(name);
  });
});

/** The cells of each row of the tables under a heading, up to the next heading of its level. */
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
