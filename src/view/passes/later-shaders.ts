import { addShaderFiles } from '../shader-files.ts';

/** These shaders belong to the passes that are not in the first picture. */
addShaderFiles(
  import.meta.glob<string>(
    '../../../shaders/passes/{checkerboard,line,lit-limb,overlay,planar-shadow,point-mark,reflection,solid,weights}.*.glsl',
    { query: '?raw', import: 'default', eager: true },
  ),
);
