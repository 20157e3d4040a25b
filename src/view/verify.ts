import { diagonal } from '../core/bounds.ts';
import { type Actor, skinInUse } from '../document/scene.ts';
import type { Difference, Verification } from '../document/verification.ts';
import { largestBindError } from '../skinning/bind-error.ts';
import type { VertexStreams } from '../skinning/method.ts';
import type { Viewer } from './viewer.ts';

/** Compares the buffers that are drawn, which most methods fill on the GPU, with the CPU's vertices. */
export function verifyShown(actor: Actor | undefined, viewer: Viewer): Verification | null {
  if (!actor || !viewer.available.value || viewer.refusalOf(actor) !== null) return null;
  const [gpu, cpu] = [viewer.skin(actor, 'gpu'), viewer.skin(actor, 'cpu')];
  return verifySkin(actor, gpu, cpu, 'finish' in viewer.evaluations.of(actor).method);
}

export function verifySkin(
  state: Actor,
  gpu: VertexStreams,
  cpu: VertexStreams,
  isOnCpu = false,
): Verification {
  const { character } = state;
  const difference = compareVertices(gpu, cpu, character.mesh.pointOf);
  return {
    ...difference,
    isOnCpu,
    relative: difference.position / (diagonal(character.bounds) || 1),
    bindError: character.skin.bindFromJoint
      ? null
      : largestBindError(character.skeleton, skinInUse(state)),
  };
}

/** @param pointOf (vertexCount) the point of each render vertex */
function compareVertices(a: VertexStreams, b: VertexStreams, pointOf: Uint32Array): Difference {
  const positions = largestDifference(a.positions, b.positions);
  const normals = largestDifference(a.normals, b.normals);
  return {
    position: positions.size,
    vertex: positions.size === 0 ? 0 : pointOf[Math.floor(positions.index / 3)]! + 1,
    normal: normals.size,
    identical: sameBits(a.positions, b.positions) && sameBits(a.normals, b.normals),
  };
}

function largestDifference(a: Float32Array, b: Float32Array): { size: number; index: number } {
  let size = 0;
  let index = 0;
  for (let i = 0; i < a.length; i++) {
    const difference = Math.abs(a[i]! - b[i]!);
    if (difference <= size) continue; // NaN is not smaller; it counts as the largest difference
    size = Number.isNaN(difference) ? Infinity : difference;
    index = i;
    if (size === Infinity) break;
  }
  return { size, index };
}

function sameBits(a: Float32Array, b: Float32Array): boolean {
  const [x, y] = [bitsOf(a), bitsOf(b)];
  return x.length === y.length && x.every((bits, i) => bits === y[i]);
}

function bitsOf({ buffer, byteOffset, length }: Float32Array): Uint32Array {
  return new Uint32Array(buffer, byteOffset, length);
}
