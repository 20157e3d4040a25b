import { spawnSync } from 'node:child_process';
import path from 'node:path';
import { expect } from '@playwright/test';

const bundle = path.resolve(import.meta.dirname, '../../build/sinew.mjs');

/** Runs the command line as it was built with the page. */
export function sinew(...words: readonly string[]): void {
  const { status, stderr } = spawnSync(process.execPath, [bundle, ...words], { encoding: 'utf8' });
  expect(status, stderr).toBe(0);
}
