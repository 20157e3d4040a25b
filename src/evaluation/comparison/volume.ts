import type { Mesh } from '../../core/mesh.ts';
import type { Evaluation } from '../evaluation.ts';
import { closedComponents } from './closed-components.ts';
import { enclosedVolume } from './enclosed-volume.ts';

/**
 * Returns the volume of a posed mesh as a part of its volume at rest, or null if it encloses none.
 * Only closed parts of at least 1 % of the area count. Vertices that are at one place at rest are
 * posed as the first of them, so that a part stays closed where they come apart.
 *
 * @param mesh before its rest layers, by which its parts are found
 * @param rest (vertexCount × 3) to compare with
 * @param posed (vertexCount × 3)
 */
export function volumeRatio(
  mesh: Pick<Mesh, 'positions' | 'indices'>,
  rest: Float32Array,
  posed: Float32Array,
): number | null {
  let [before, after] = [0, 0];
  for (const corners of closedComponents(mesh)) {
    const volume = enclosedVolume(rest, corners);
    before += Math.abs(volume);
    after += Math.sign(volume) * enclosedVolume(posed, corners);
  }
  return before > 0 ? after / before : null;
}

/** Returns the same for a character as it is posed, against its mesh after its rest layers. */
export function volumeRatioOf(evaluation: Evaluation): number | null {
  const { state, rest } = evaluation;
  return volumeRatio(state.character.mesh, rest.positions, evaluation.vertices().positions);
}
