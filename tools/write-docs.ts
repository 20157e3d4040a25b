/**
 * Writes the pages of docs that only repeat a table of the code: docs/cli.md and docs/keys.md. A unit
 * test fails where they are not what the tables give.
 */
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { format } from 'prettier';
import type { Command } from '../src/cli/command.ts';
import { commands } from '../src/cli/commands.ts';
import { contexts, type HelpRow, keyRows, pointerRows } from '../src/ui/commands/contexts.ts';
import { isMain, root } from './commands.mjs';

/** Every written page, by its path from the root of the project. */
const pages: readonly { readonly file: string; readonly lines: () => string[] }[] = [
  { file: 'docs/cli.md', lines: cliPage },
  { file: 'docs/keys.md', lines: keysPage },
];

/** The text that each page should have, laid out as `npm run format` would do it. */
export function writtenPages(): Promise<{ file: string; text: string }[]> {
  return Promise.all(
    pages.map(async ({ file, lines }) => {
      const text = await format(lines().join('\n'), { parser: 'markdown' });
      return { file, text };
    }),
  );
}

function cliPage(): string[] {
  return [
    '# The command line',
    '',
    '`npm run docs` writes this page from the table in `src/cli/commands.ts`.',
    '',
    'A command is run as `npm run --silent sinew -- COMMAND`; `help` prints what stands here. Problems go',
    "to stderr. The exit code is 0, 1 for a file that can't be used, and 2 for wrong usage.",
    '',
    ...commands.flatMap(commandSection),
  ];
}

function commandSection({ name, usage, summary }: Command): string[] {
  return [`## ${name}`, '', summary, '', '```text', `sinew ${usage}`, '```', ''];
}

function keysPage(): string[] {
  return [
    '# Keys and pointer',
    '',
    '`npm run docs` writes this page from the tables in `src/ui/commands`.',
    '',
    'Where several sections have the same key, the first whose state holds is meant. Keys of a single',
    'character can be turned off in the help sheet, and in fields and lists only those with Ctrl or Cmd',
    'act.',
    '',
    '## The pointer on the view',
    '',
    ...table(pointerRows),
    ...contexts.flatMap(({ id, label }) => [
      `## ${label || 'Everywhere'}`,
      '',
      ...keyTable(keyRows(id)),
    ]),
  ];
}

function keyTable(rows: readonly HelpRow[]): string[] {
  return table(rows.map(([key, does]) => [`\`${key}\``, does]));
}

function table(rows: readonly HelpRow[]): string[] {
  const lines = rows.map(([key, does]) => `| ${key} | ${does} |`);
  return ['| key | does |', '| --- | --- |', ...lines, ''];
}

if (isMain(import.meta.url)) {
  for (const { file, text } of await writtenPages()) writeFileSync(path.join(root, file), text);
}
