import { DofKind, type Skeleton } from './skeleton.ts';

/** What forward kinematics knows about a skeleton in advance, with room for its sines. */
export interface CoordinateHinges {
  /** (dofCount) the axis of a hinge about a coordinate axis: 0 for x, 1 for y, 2 for z; else 3. */
  readonly axes: Uint8Array;
  /** (jointCount) 1 for joints that only have such hinges, and no rotation at rest. */
  readonly only: Uint8Array;
  /** (dofCount) of the angles of all hinges; see `writeSines`. */
  readonly sines: Float64Array;
  readonly cosines: Float64Array;
}

const noAxis = 3;

const known = new WeakMap<Skeleton, CoordinateHinges>();

/** Finds the hinges about coordinate axes, at the first call for a skeleton. */
export function coordinateHinges(skeleton: Skeleton): CoordinateHinges {
  let found = known.get(skeleton);
  if (!found) known.set(skeleton, (found = findHinges(skeleton)));
  return found;
}

/**
 * Writes the sines and cosines of the angles of all hinges. Calls of Math are most of the time of
 * forward kinematics, so both come from one: with t = tan(angle / 2), the sine is 2 t / (1 + t²) and
 * the cosine (1 − t²) / (1 + t²), which loses no accuracy.
 */
export function writeSines(
  { dofQ }: Skeleton,
  { sines, cosines }: CoordinateHinges,
  q: Float64Array,
): void {
  for (let dof = 0; dof < dofQ.length; dof++) {
    const t = Math.tan(0.5 * q[dofQ[dof]!]!);
    const scale = 1 / (1 + t * t);
    sines[dof] = 2 * t * scale;
    cosines[dof] = (1 - t * t) * scale;
  }
}

function findHinges(skeleton: Skeleton): CoordinateHinges {
  const { jointCount, restRotations, dofStart, dofKind, dofAxis } = skeleton;
  const axes = Uint8Array.from(dofKind, (kind, dof) => {
    const axis = dofAxis.subarray(dof * 3, dof * 3 + 3).indexOf(1);
    return kind === DofKind.hinge && axis >= 0 ? axis : noAxis;
  });
  const only = Uint8Array.from({ length: jointCount }, (_, joint) => {
    const [x, y, z] = restRotations.subarray(joint * 4, joint * 4 + 3);
    const own = axes.subarray(dofStart[joint], dofStart[joint + 1]);
    return x === 0 && y === 0 && z === 0 && !own.includes(noAxis) ? 1 : 0;
  });
  return {
    axes,
    only,
    sines: new Float64Array(axes.length),
    cosines: new Float64Array(axes.length),
  };
}
