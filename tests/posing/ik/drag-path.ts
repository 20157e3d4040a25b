import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import type { Skeleton } from '../../../src/core/skeleton.ts';
import {
  ChainDrag,
  type ChainDragStart,
  type ChainMoment,
} from '../../../src/posing/ik/chain-drag.ts';
import type { Vector3 } from '../../../src/posing/ik/problem.ts';

/** Where the hand is at a time in seconds. */
export type Path = (seconds: number) => Vector3;

/** A drag that a test plays, and every moment that it showed. */
export interface Played {
  readonly drag: ChainDrag;
  readonly moments: readonly ChainMoment[];
  readonly end: ChainMoment;
}

/** Plays a path at a rate of frames, and then lets the hand rest until the drag does. */
export function play(start: ChainDragStart, path: Path, duration: number, rate: number): Played {
  const drag = new ChainDrag(start);
  const moments: ChainMoment[] = [];
  for (let frame = 1; frame <= Math.round(duration * rate); frame++) {
    drag.aim(path(frame / rate), frame / rate);
    moments.push(drag.advance(frame / rate));
  }
  for (let frame = Math.round(duration * rate) + 1; !moments.at(-1)!.isAtRest; frame++) {
    if (frame > (duration + 3) * rate) throw new Error('the drag does not come to rest');
    moments.push(drag.advance(frame / rate));
  }
  return { drag, moments, end: moments.at(-1)! };
}

/** How far each joint's own rotation is from that in another pose, in degrees. */
export function turnsBetween(skeleton: Skeleton, a: Float64Array, b: Float64Array): number[] {
  const [from, to] = [localRotations(skeleton, a), localRotations(skeleton, b)];
  return from.map((rotation, joint) => {
    // The trace of AᵀB is 1 + 2 cos θ, and |A − B|² is 8 sin²(θ / 2), which keeps small angles.
    const squared = rotation.reduce((sum, value, i) => sum + (value - to[joint]![i]!) ** 2, 0);
    return (2 * Math.asin(Math.min(1, Math.sqrt(squared / 8))) * 180) / Math.PI;
  });
}

/** The rotation matrix of each joint in its parent, row by row. */
function localRotations(skeleton: Skeleton, q: Float64Array): number[][] {
  const matrices = jointMatrices(skeleton, q);
  const element = (joint: number, row: number, column: number): number =>
    joint < 0 ? Number(row === column) : matrices[joint * 16 + column * 4 + row]!;
  const indices = [0, 1, 2];
  return Array.from(skeleton.parents, (parent, joint) =>
    indices.flatMap((row) =>
      indices.map((column) =>
        indices.reduce((sum, k) => sum + element(parent, k, row) * element(joint, k, column), 0),
      ),
    ),
  );
}
