import { vec3 } from 'gl-matrix';
import type { CharacterView } from '../character-view.ts';
import { InstancedSolid, instanceSize } from '../instanced-solid.ts';
import type { Pass } from '../pass.ts';
import { keyOf } from '../solid-instances.ts';
import { segment } from '../solid-shapes.ts';
import { palette } from '../theme.ts';

/** In parts of the character's height. */
const lineLength = 0.02;
/** In pixels. */
const lineWidth = 1;

/**
 * Draws the normals that the skin is shaded with as lines: those of the vertices or, of a faceted skin,
 * those of the faces from their middles.
 */
export const normalLinesPass: Pass = {
  id: 'normal-lines',
  isShown: ({ showNormals, showSkin }) => showNormals && showSkin,
  create(gpu, programs) {
    const program = programs.pass('line');
    const lines = new InstancedSolid(gpu, program, segment());
    return {
      draw(frame) {
        const shadings = frame.characters.map(
          ({ state, evaluation }) => `${state.look.shading} ${evaluation.revisions.normals}`,
        );
        lines.update(`${keyOf(frame.characters)} ${shadings.join()}`, () =>
          frame.characters.map(normalInstances),
        );
        program.use();
        program.set(frame.uniforms);
        program.set({ opacity: 1, wrapped: false, lineWidth: lineWidth * frame.scale });
        lines.draw();
      },
      dispose: () => lines.dispose(),
    };
  },
};

function normalInstances({ evaluation, state, display }: CharacterView): Float32Array {
  const { positions, normals } = evaluation.vertices();
  const { indices, vertexCount } = state.character.mesh;
  const isFaceted = state.look.shading === 'faceted';
  const count = isFaceted ? indices.length / 3 : vertexCount;
  const instances = new Float32Array(count * instanceSize);
  const length = lineLength * state.transform.scale;
  for (let index = 0; index < count; index++) {
    if (isFaceted) placeOnFace(positions, indices, index);
    else {
      vec3.set(origin, positions[index * 3]!, positions[index * 3 + 1]!, positions[index * 3 + 2]!);
      vec3.set(along, normals[index * 3]!, normals[index * 3 + 1]!, normals[index * 3 + 2]!);
    }
    writeInstance(instances, index * instanceSize, display.sceneFromCharacter, length);
  }
  return instances;
}

function placeOnFace(positions: Float32Array, indices: Uint32Array, face: number): void {
  for (const [i, corner] of corners.entries()) {
    const at = indices[face * 3 + i]! * 3;
    vec3.set(corner, positions[at]!, positions[at + 1]!, positions[at + 2]!);
  }
  const [a, b, c] = corners;
  vec3.add(origin, a, b);
  vec3.scale(origin, vec3.add(origin, origin, c), 1 / 3);
  vec3.cross(along, vec3.subtract(b, b, a), vec3.subtract(c, c, a));
}

/** Writes a line from `origin` along `along`, both in the character's space. */
function writeInstance(
  instances: Float32Array,
  to: number,
  sceneFromCharacter: Float64Array,
  length: number,
): void {
  const m = sceneFromCharacter;
  for (let row = 0; row < 3; row++) {
    turned[row] = m[row]! * along[0] + m[4 + row]! * along[1] + m[8 + row]! * along[2];
  }
  vec3.normalize(turned, turned);
  vec3.transformMat4(origin, origin, m);
  for (let row = 0; row < 3; row++) {
    instances[to + row * 4 + 1] = turned[row]! * length;
    instances[to + row * 4 + 3] = origin[row]!;
    instances[to + 12 + row] = palette.boneLine[row]!;
  }
}

const [origin, along, turned]: [vec3, vec3, vec3] = [
  new Float64Array(3),
  new Float64Array(3),
  new Float64Array(3),
];
const corners: readonly [vec3, vec3, vec3] = [
  new Float64Array(3),
  new Float64Array(3),
  new Float64Array(3),
];
