import { existsSync, readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { expect, test } from 'vitest';
import { root } from '../../tools/commands.mjs';

/** A path from the root of the project; the end of a longer path does not count. */
const namedPath = /(?<![\w./-])(?:src|tests|e2e|shaders|tools|docs|public)\/[\w./-]*\w/g;

const pages = [
  ...readdirSync(path.join(root, 'docs'), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.md'))
    .map((name) => path.join('docs', name)),
  'README.md',
  'CONTRIBUTING.md',
];

test.each(pages)('%s names only paths that exist', (page) => {
  const text = readFileSync(path.join(root, page), 'utf8');
  const named = [...text.matchAll(namedPath)].map(([found]) => found);
  // NAME stands for a file that does not exist yet.
  const missing = named.filter(
    (each) => !each.includes('NAME') && !existsSync(path.join(root, each)),
  );
  expect(missing).toEqual([]);
});
