import { quat, type ReadonlyMat3, vec3 } from 'gl-matrix';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';

/**
 * Writes the values of a joint's partner, computed from those of the joint. Returns whether the
 * partner's degrees of freedom can take what was mirrored.
 *
 * @param from (qCount) the pose that is mirrored
 * @param to (qCount) another array, of which only the partner's values are written
 */
export type JointMirror = (from: Float64Array, to: Float64Array) => boolean;

/** The most by which axes and values may differ from mirror images of each other. */
const exact = 1e-9;

/**
 * Returns how a joint's values become those of its partner one by one, regardless of limits: by signs, and the vector part
 * of a ball by a rotation that is the same for all values. Returns null unless the two joints have
 * the same degrees of freedom about mirrored axes, and mirrored values at the reference.
 *
 * @param turn as `mirrorFrames` returns it for these joints
 * @param reference (qCount)
 */
export function valueMirror(
  skeleton: Skeleton,
  [joint, partner]: readonly [number, number],
  turn: ReadonlyMat3,
  reference: Float64Array,
): JointMirror | null {
  const { dofStart, dofKind, dofAxis, dofQ } = skeleton;
  const [first, end] = [dofStart[joint]!, dofStart[joint + 1]!];
  const shift = dofStart[partner]! - first;
  if (dofStart[partner + 1]! - dofStart[partner]! !== end - first) return null;
  const mirrors: ((from: Float64Array, to: Float64Array) => void)[] = [];
  for (let dof = first; dof < end; dof++) {
    const kind = dofKind[dof] as DofKind;
    const other = dof + shift;
    if (dofKind[other] !== kind) return null;
    const [index, target] = [dofQ[dof]!, dofQ[other]!];
    if (kind === DofKind.ball) {
      mirrors.push((from, to) => {
        const vector = vec3.transformMat3(zero(), from.subarray(index, index + 3), turn);
        to.set([vector[0] + 0, vector[1] + 0, vector[2] + 0, from[index + 3]!], target);
      });
      continue;
    }
    const own = vec3.transformMat3(zero(), dofAxis.subarray(dof * 3, dof * 3 + 3), turn);
    const theirs = dofAxis.subarray(other * 3, other * 3 + 3);
    const sign = vec3.dot(own, theirs) < 0 ? -1 : 1;
    if (vec3.distance(vec3.scale(own, own, sign), theirs) > exact) return null;
    const factor = kind === DofKind.slide ? -sign : sign;
    // Adding zero makes a negative zero the usual one.
    mirrors.push((from, to) => (to[target] = factor * from[index]! + 0));
  }
  const mirror: JointMirror = (from, to) => {
    for (const each of mirrors) each(from, to);
    return true;
  };
  return keeps(skeleton, partner, reference, mirror) ? mirror : null;
}

/** Whether the mirrored reference is the reference of the partner. */
function keeps(
  { dofStart, dofKind, dofQ }: Skeleton,
  partner: number,
  reference: Float64Array,
  mirror: JointMirror,
): boolean {
  const mirrored = reference.slice();
  mirror(reference, mirrored);
  for (let dof = dofStart[partner]!; dof < dofStart[partner + 1]!; dof++) {
    const at = dofQ[dof]!;
    if (dofKind[dof] === DofKind.ball) {
      const [a, b] = [mirrored.subarray(at, at + 4), reference.subarray(at, at + 4)];
      // Both quaternions of a rotation are it.
      const sign = quat.dot(a, b) < 0 ? -1 : 1;
      if (a.some((value, i) => Math.abs(value - sign * b[i]!) > exact)) return false;
    } else if (Math.abs(mirrored[at]! - reference[at]!) > exact) return false;
  }
  return true;
}

function zero(): vec3 {
  return new Float64Array(3);
}
