import { DofKind, type Skeleton } from './skeleton.ts';

/** What forward kinematics knows about a skeleton in advance, with room for its sines. */
export interface CoordinateHinges {
  /** (dofCount) the coordinate axis of each hinge about one: 0 for x, 1 for y, 2 for z. */
  readonly axes: Uint8Array;
  /** (jointCount) 1 for joints that only have such hinges, and no rotation at rest. */
  readonly only: Uint8Array;
  /** (dofCount) of the angles of all hinges; see `writeSines`. */
  readonly sines: Float64Array;
  readonly cosines: Float64Array;
}

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
  const axes = Uint8Array.from(dofKind, (_, dof) =>
    Math.max(0, dofAxis.subarray(dof * 3, dof * 3 + 3).indexOf(1)),
  );
  const only = Uint8Array.from({ length: jointCount }, (_, joint) => {
    const dofs = Array.from(axes.keys()).slice(dofStart[joint], dofStart[joint + 1]);
    const isOnly = dofs.every(
      (dof) => dofKind[dof] === DofKind.hinge && dofAxis[dof * 3 + axes[dof]!] === 1,
    );
    return isOnly && restRotations[joint * 4 + 3] === 1 ? 1 : 0;
  });
  const [sines, cosines] = [new Float64Array(axes.length), new Float64Array(axes.length)];
  return { axes, only, sines, cosines };
}
