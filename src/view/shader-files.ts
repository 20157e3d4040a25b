import type { ShaderFiles } from '../gl/shader-library.ts';

const root = '../../shaders/';

/** All shaders of the app, by path below shaders/. */
export const shaderFiles: ShaderFiles = Object.fromEntries(
  Object.entries(
    import.meta.glob<string>('../../shaders/**/*.glsl', {
      query: '?raw',
      import: 'default',
      eager: true,
    }),
  ).map(([path, source]) => [path.slice(root.length), source]),
);
