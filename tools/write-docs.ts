/**
 * Generates the pages of docs that repeat a table: docs/cli.md and docs/keys.md from the code, and the
 * table of docs/performance.md from the ledger of the bench. A unit test fails if a page differs from
 * what its table gives.
 */
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { format } from 'oxfmt';
import type { Command } from '../src/cli/command.ts';
import { performanceFile, performancePage } from '../bench/harness/performance-page.ts';
import { commands } from '../src/cli/commands.ts';
import { contexts, type HelpRow, keyRows, pointerRows } from '../src/ui/commands/contexts.ts';
import { isMain, root } from './commands.mjs';

/** Every generated page, by its path from the root of the project. */
const pages: readonly { readonly file: string; readonly lines: () => string[] }[] = [
  { file: 'docs/cli.md', lines: cliPage },
  { file: 'docs/keys.md', lines: keysPage },
  { file: performanceFile, lines: performancePage },
];

/** Returns the text that each page should have, formatted as by `npm run format`. */
export function writtenPages(): Promise<{ file: string; text: string }[]> {
  return Promise.all(
    pages.map(async ({ file, lines }) => {
      const { code } = await format(file, lines().join('\n'));
      return { file, text: code };
    }),
  );
}

function cliPage(): string[] {
  return [
    '# The command line',
    '',
    '`npm run docs` generates this page from the table in `src/cli/commands.ts`.',
    '',
    'Run a command as `npm run --silent sinew -- COMMAND`. `help` prints the list below, and with a command,',
    'as `COMMAND --help` does, what that one takes. Problems are printed to stderr. The exit code is 0 on',
    "success, 1 for a file that can't be used, and 2 for wrong usage.",
    '',
    'After `npm run build`, the same command runs the one file `build/sinew.mjs`, which starts several times',
    'faster than the sources and can also be run alone: `node build/sinew.mjs COMMAND`. When the sources',
    'change, the command runs them until the next build. `npm link` makes it available as `sinew`.',
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
    '`npm run docs` generates this page from the tables in `src/ui/commands`.',
    '',
    'If several sections list the same key, the first section whose state applies takes precedence.',
    'Single-character keys can be turned off in the help sheet. In text fields and lists, only keys with',
    'Ctrl or Cmd act.',
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
  return ['| key | action |', '| --- | --- |', ...lines, ''];
}

export async function writeDocs(): Promise<void> {
  for (const { file, text } of await writtenPages()) writeFileSync(path.join(root, file), text);
}

if (isMain(import.meta.url)) await writeDocs();
