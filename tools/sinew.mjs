#!/usr/bin/env node
/**
 * Runs the command line: the bundle that `npm run build` makes, if it was made from the present
 * sources, and otherwise the sources themselves, which takes longer to start.
 */
import { closeSync, existsSync, openSync, readSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { root } from './commands.mjs';
import { sourcesHash } from './sources-hash.mjs';

const bundle = path.join(root, 'build/sinew.mjs');

if (existsSync(bundle) && startOf(bundle).includes(sourcesHash())) {
  await import(pathToFileURL(bundle).href);
} else {
  try {
    const { install } = await import('./install.mjs');
    install();
    const { register } = await import('tsx/esm/api');
    register();
    await import('../src/cli/main.ts');
  } catch (error) {
    console.error(error instanceof Error ? error.message : error);
    process.exitCode = 1;
  }
}

/**
 * Returns the first characters of a file, where the bundle states its hash.
 * @param {string} file
 */
function startOf(file) {
  const start = Buffer.alloc(256);
  const descriptor = openSync(file, 'r');
  readSync(descriptor, start);
  closeSync(descriptor);
  return start.toString('latin1');
}
