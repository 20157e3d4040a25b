import { addShaderFiles } from '../shader-files.ts';

/** These shaders draw surfaces that are covered with something. */
addShaderFiles(
  import.meta.glob<string>('../../../shaders/passes/{mesh-mapped,mesh-textured}.*.glsl', {
    query: '?raw',
    import: 'default',
    eager: true,
  }),
);
