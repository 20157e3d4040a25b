import { diagonal } from '../core/bounds.ts';
import type { ActorId } from '../document/scene.ts';
import { differenceOf, leastPart, sizeOf } from '../evaluation/comparison/difference.ts';
import { verticesBy } from '../evaluation/comparison/vertices-by.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import type { Kernels } from '../evaluation/kernels.ts';
import type { MethodId } from '../skinning/method.ts';
import { colorAt, errorRamp, zeroColor } from '../skinning/weights/ramps.ts';

interface Painted {
  readonly revision: number;
  readonly colors: Uint8Array;
}

/**
 * Returns what gives the vertices of characters colors for how far they are from where another method
 * puts them: gray where they are at the same place, and the last color at `scale`.
 *
 * @param baseOf returns that method of a character
 * @param scale as a part of each character's height, so that a color means the same on all of them
 */
export function heatPaint(
  baseOf: (id: ActorId) => MethodId,
  kernels: Kernels,
  scale: number,
): (evaluation: Evaluation) => Uint8Array {
  const held = new WeakMap<Evaluation, Painted>();
  return (evaluation) => {
    const revision = evaluation.revisions.vertices;
    const former = held.get(evaluation);
    if (former?.revision === revision) return former.colors;
    const { id, character } = evaluation.state;
    const positions = verticesBy(evaluation, { method: baseOf(id) }, kernels);
    const { height } = sizeOf(character);
    const colors = heatColors(evaluation, positions, scale * height);
    held.set(evaluation, { revision, colors });
    return colors;
  };
}

function heatColors(evaluation: Evaluation, base: Float32Array, scale: number): Uint8Array {
  const { mesh, bounds } = evaluation.state.character;
  const { positions } = evaluation.vertices();
  const least = leastPart * diagonal(bounds);
  const { distances } = differenceOf(positions, base, mesh.vertexCount, least);
  const colors = new Uint8Array(mesh.vertexCount * 4).fill(255);
  distances.forEach((distance, vertex) => {
    const color = distance === 0 ? zeroColor : colorAt(errorRamp, distance / scale);
    colors.set(color, vertex * 4);
  });
  return colors;
}
