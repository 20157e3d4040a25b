import { Buffer } from '../../gl/buffer.ts';
import type { Gpu } from '../../gl/gpu.ts';
import { IntegerTarget } from '../../gl/integer-target.ts';
import { Owner } from '../../gl/owner.ts';
import type { Program } from '../../gl/program.ts';
import { VertexArray } from '../../gl/vertex-array.ts';
import type { CharacterView } from '../character-view.ts';
import type { Frame } from '../frame.ts';
import type { Renderer } from '../renderer.ts';
import { addShaderFiles } from '../shader-files.ts';

addShaderFiles(
  import.meta.glob<string>('../../../shaders/passes/geometry.*.glsl', {
    query: '?raw',
    import: 'default',
    eager: true,
  }),
);

const textureUnit = 4;

/**
 * Which triangle of which character each pixel shows, and where on it: (width × height × 4) numbers,
 * the bottom row first. They are the character's index in the frame plus 1 (0 for nothing), the index
 * of the triangle, and the bits of two floats, the weights of its second and third corner.
 */
export type Geometry = Uint32Array;

/** Draws the geometry of a frame, exactly at the middle of each pixel. */
export function drawGeometry({ gpu, programs }: Renderer, frame: Frame): Geometry {
  const { gl } = gpu;
  const { width, height } = frame.viewport;
  const program = programs.pass('geometry');
  const target = new IntegerTarget(gpu, width, height);
  try {
    target.begin();
    program.use();
    program.set(frame.uniforms);
    for (const [index, view] of frame.characters.entries()) {
      program.set({ character: index + 1, sceneFromCharacter: view.display.sceneFromCharacter });
      drawCorners(gpu, program, view, frame.options.showTextures);
    }
    gl.bindVertexArray(null);
    return target.readPixels();
  } finally {
    target.dispose();
  }
}

/** A surface that shows less than half of its own color counts as a hole. */
function drawCorners(
  gpu: Gpu,
  program: Program,
  { evaluation, surfaces, dress, state: { look } }: CharacterView,
  showTextures: boolean,
): void {
  const { gl } = gpu;
  const { indices, uvs } = evaluation.state.character.mesh;
  const owner = new Owner();
  try {
    const corners = (values: Float32Array, size: number): Buffer =>
      owner.own(new Buffer(gpu, 'vertex', valuesOfCorners(indices, values, size)));
    const array = new VertexArray(gpu, program, {
      cornerPosition: { buffer: corners(evaluation.vertices().positions, 3), size: 3 },
      ...(uvs && { uv: { buffer: corners(uvs, 2), size: 2 } as const }),
    });
    owner.own(array);
    array.bind();
    for (const { submesh, alpha, twoSided, texture: name } of surfaces) {
      const cover = showTextures ? dress?.coverOf(name, look) : undefined;
      // What is projected has no holes here.
      const textured = cover?.program === 'mesh-textured';
      if (textured) cover.bind(textureUnit);
      program.set({ opacity: alpha, textured, colorTexture: textureUnit });
      if (!twoSided) gl.enable(gl.CULL_FACE);
      gl.drawArrays(gl.TRIANGLES, submesh.firstIndex, submesh.indexCount);
      gl.disable(gl.CULL_FACE);
    }
  } finally {
    owner.dispose();
  }
}

/** The values of vertices, once for each corner of a triangle. */
function valuesOfCorners(indices: Uint32Array, values: Float32Array, size: number): Float32Array {
  const out = new Float32Array(indices.length * size);
  indices.forEach((vertex, corner) => {
    for (let i = 0; i < size; i++) out[corner * size + i] = values[vertex * size + i]!;
  });
  return out;
}
