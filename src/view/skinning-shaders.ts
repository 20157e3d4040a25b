import { addShaderFiles } from './shader-files.ts';

/** The GLSL with which kernels run on the GPU, except linear blend's. */
addShaderFiles(
  import.meta.glob<string>(
    [
      '../../shaders/lib/quaternions.glsl',
      '../../shaders/skinning/*.glsl',
      '!**/skinning/{stage.*,linear-blend}.glsl',
    ],
    { query: '?raw', import: 'default', eager: true },
  ),
);
