/** GLSL sources by their paths below shaders/, for example "lib/studio.glsl". */
export type ShaderFiles = Readonly<Record<string, string>>;

export type Defines = Readonly<Record<string, number>>;

const header = [
  '#version 300 es',
  'precision highp float;',
  'precision highp int;',
  'precision highp sampler2D;',
  'precision highp usampler2D;',
];

/**
 * Returns the whole source of a stage. Version, precision and defines come first, and each
 * `#include "path"` is resolved, each file once.
 *
 * @param names replaces words in include paths: {METHOD: 'rigid'} for "skinning/METHOD.glsl"
 */
export function resolveShader(
  files: ShaderFiles,
  entry: string,
  defines: Defines = {},
  names: Readonly<Record<string, string>> = {},
): string {
  const included = new Set<string>();
  const constants = Object.entries(defines).map(([name, value]) => `#define ${name} ${value}`);
  return [...header, ...constants, include(entry)].join('\n');

  function include(path: string): string {
    if (included.has(path)) return '';
    included.add(path);
    const source = files[path];
    if (source === undefined) throw new Error(`there is no shader "${path}"`);
    return source.replace(/^[ \t]*#include "([^"]+)"[ \t]*$/gm, (_, named: string) => {
      const target = named.replace(/[A-Z]+/g, (word) => names[word] ?? word);
      return include(target);
    });
  }
}
