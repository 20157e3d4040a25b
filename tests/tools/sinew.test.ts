import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { expect, it, onTestFinished } from 'vitest';

const root = resolve(import.meta.dirname, '../..');

it('runs the bundle of the present sources, and otherwise the sources', () => {
  const project = mkdtempSync(join(tmpdir(), 'sinew-'));
  onTestFinished(() => rmSync(project, { recursive: true }));
  const write = (file: string, text: string) => {
    mkdirSync(dirname(join(project, file)), { recursive: true });
    writeFileSync(join(project, file), text);
  };
  const run = (script: string) =>
    execFileSync(process.execPath, [join(project, script)], { encoding: 'utf8' }).trim();

  for (const file of ['package.json', 'package-lock.json', 'vite.cli.config.ts', 'tools']) {
    cpSync(join(root, file), join(project, file), { recursive: true });
  }
  symlinkSync(join(root, 'node_modules'), join(project, 'node_modules'), 'junction');
  write('src/cli/main.ts', "console.log('the sources' satisfies string);");
  expect(run('tools/sinew.mjs'), 'without a bundle').toBe('the sources');

  write(
    'hash.mjs',
    "import { sourcesHash } from './tools/sources-hash.mjs'; console.log(sourcesHash());",
  );
  write(
    'build/sinew.mjs',
    `#!/usr/bin/env node\n// Sources: ${run('hash.mjs')}\nconsole.log('the bundle');`,
  );
  expect(run('tools/sinew.mjs'), 'with its bundle').toBe('the bundle');

  write('src/core/added.ts', 'export {};');
  expect(run('tools/sinew.mjs'), 'with a new file').toBe('the sources');
});
