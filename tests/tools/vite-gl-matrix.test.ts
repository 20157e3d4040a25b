import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { markPure } from '../../tools/vite-gl-matrix.ts';

const sourceOf = (name: string): string =>
  readFileSync(fileURLToPath(import.meta.resolve(`gl-matrix/esm/${name}.js`)), 'utf8');

describe('gl-matrix’s functions that are made at load', () => {
  it.each([
    ['vec3', 1],
    ['vec4', 1],
    ['quat', 3],
    ['mat4', 0],
  ])('are all marked in %s', (name, count) => {
    const code = sourceOf(name);
    expect(code.match(/^\}\(\);$/gm) ?? []).toHaveLength(count);
    expect(markPure(code).match(/= \/\* @__PURE__ \*\/ function/g) ?? []).toHaveLength(count);
  });

  it('are the only thing that changes', () => {
    const code = sourceOf('quat');
    expect(markPure(code).replaceAll('/* @__PURE__ */ ', '')).toBe(code);
  });
});
