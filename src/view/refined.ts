import { addShaderFiles } from './shader-files.ts';

export { closedTriangles } from './closed-triangles.ts';
export { ContactShadow } from './contact-shadow.ts';

addShaderFiles(
  import.meta.glob<string>('../../shaders/passes/{blur,contact-shadow}.*.glsl', {
    query: '?raw',
    import: 'default',
    eager: true,
  }),
);
