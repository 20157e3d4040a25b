import { coordinateHinges, writeSines } from './coordinate-hinges.ts';
import { applyDof, applyRest } from './joint-transforms.ts';
import { noParent, type Skeleton } from './skeleton.ts';

/**
 * Writes the matrix from every joint's frame to the character's space, for the values q.
 *
 * `characterFromJoint[j] = characterFromJoint[parent] · T(offset) · R(rest) · D1 · … · Dk` (6.837
 * handout, part 3; the degrees of freedom follow MuJoCo's `qpos`). It visits the depth-first joints
 * once, in float64, and allocates nothing. The matrices that are already written take the place of
 * the handout's matrix stack: that of the parent is the one that would be on top.
 *
 * @param q (qCount) see `Skeleton.dofQ`
 * @param characterFromJoint (jointCount × 16) column-major, written
 */
export function forwardKinematics(
  skeleton: Skeleton,
  q: Float64Array,
  characterFromJoint: Float64Array,
): void {
  const { jointCount, parents, restOffsets, dofStart } = skeleton;
  const hinges = coordinateHinges(skeleton);
  const { axes, only, sines, cosines } = hinges;
  const out = characterFromJoint;
  writeSines(skeleton, hinges, q);
  for (let joint = 0; joint < jointCount; joint++) {
    const parent = parents[joint]!;
    const above = parent === noParent ? identity : out;
    const from = parent === noParent ? 0 : parent * 16;
    const to = joint * 16;
    if (only[joint] === 0) {
      for (let i = 0; i < 16; i++) out[to + i] = above[from + i]!;
      applyRest(skeleton, joint, out, to);
      const end = dofStart[joint + 1]!;
      for (let dof = dofStart[joint]!; dof < end; dof++) applyDof(skeleton, dof, q, out, to);
      continue;
    }
    // The columns x, y and z of parentFromJoint are single variables, which stay in registers.
    let xx = 1;
    let xy = 0;
    let xz = 0;
    let yx = 0;
    let yy = 1;
    let yz = 0;
    let zx = 0;
    let zy = 0;
    let zz = 1;
    const tx = restOffsets[joint * 3]!;
    const ty = restOffsets[joint * 3 + 1]!;
    const tz = restOffsets[joint * 3 + 2]!;
    const end = dofStart[joint + 1]!;
    for (let dof = dofStart[joint]!; dof < end; dof++) {
      // A rotation about a coordinate axis turns the other two columns.
      const sine = sines[dof]!;
      const cosine = cosines[dof]!;
      const axis = axes[dof]!;
      if (axis === 0) {
        const x = yx;
        const y = yy;
        const z = yz;
        yx = x * cosine + zx * sine;
        yy = y * cosine + zy * sine;
        yz = z * cosine + zz * sine;
        zx = zx * cosine - x * sine;
        zy = zy * cosine - y * sine;
        zz = zz * cosine - z * sine;
      } else if (axis === 1) {
        const x = zx;
        const y = zy;
        const z = zz;
        zx = x * cosine + xx * sine;
        zy = y * cosine + xy * sine;
        zz = z * cosine + xz * sine;
        xx = xx * cosine - x * sine;
        xy = xy * cosine - y * sine;
        xz = xz * cosine - z * sine;
      } else {
        const x = xx;
        const y = xy;
        const z = xz;
        xx = x * cosine + yx * sine;
        xy = y * cosine + yy * sine;
        xz = z * cosine + yz * sine;
        yx = yx * cosine - x * sine;
        yy = yy * cosine - y * sine;
        yz = yz * cosine - z * sine;
      }
    }
    for (let row = 0; row < 3; row++) {
      const x = above[from + row]!;
      const y = above[from + 4 + row]!;
      const z = above[from + 8 + row]!;
      out[to + row] = x * xx + y * xy + z * xz;
      out[to + 4 + row] = x * yx + y * yy + z * yz;
      out[to + 8 + row] = x * zx + y * zy + z * zz;
      out[to + 12 + row] = x * tx + y * ty + z * tz + above[from + 12 + row]!;
      out[to + row * 4 + 3] = 0;
    }
    out[to + 15] = 1;
  }
}

/** Returns the matrices of `forwardKinematics` in a new array. */
export function jointMatrices(skeleton: Skeleton, q: Float64Array): Float64Array {
  const characterFromJoint = new Float64Array(skeleton.jointCount * 16);
  forwardKinematics(skeleton, q, characterFromJoint);
  return characterFromJoint;
}

const identity = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
