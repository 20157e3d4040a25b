import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { onTestFinished } from 'vitest';
import type { FileContents } from '../support/files.ts';

const root = resolve(import.meta.dirname, '../..');

export interface Ending {
  readonly code: number | null;
  readonly out: string;
  readonly errors: string;
}

/** Runs the command line as a user does, from `folder`, while npm runs in the project's folder. */
export function runSinew(folder: string, ...words: readonly string[]): Promise<Ending> {
  return new Promise((settle, fail) => {
    const child = spawn(process.execPath, ['tools/sinew.mjs', ...words], {
      cwd: root,
      env: { ...process.env, INIT_CWD: folder },
    });
    let [out, errors] = ['', ''];
    child.stdout.on('data', (data: Buffer) => (out += data.toString()));
    child.stderr.on('data', (data: Buffer) => (errors += data.toString()));
    child.on('error', fail);
    child.on('close', (code) => settle({ code, out, errors }));
  });
}

/**
 * Makes a folder with these files that is removed when the test ends. Tests that run in parallel
 * pass the hook of their own context.
 */
export function folderWith(contents: FileContents, whenDone = onTestFinished): string {
  const folder = mkdtempSync(join(tmpdir(), 'sinew-'));
  whenDone(() => rmSync(folder, { recursive: true }));
  for (const [name, content] of Object.entries(contents)) {
    writeFileSync(join(folder, name), content);
  }
  return folder;
}
