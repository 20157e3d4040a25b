import { mat4 } from 'gl-matrix';
import type { Diagnostic } from '../../core/diagnostics.ts';
import { jointMatrices } from '../../core/forward-kinematics.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import { firstRoot } from '../../core/subtree.ts';
import type { Skin } from '../../core/skin.ts';
import { reportLosses } from './losses.ts';

/** Returns what an `.attach` can't hold of a skin. */
export function attachLosses(file: string, skin: Skin, skeleton: Skeleton): readonly Diagnostic[] {
  return reportLosses(file, 'attach/lost', [
    {
      what: 'weights on joint 0, for vertices',
      count: rowsOfFirstJoint(skin, skeleton),
      effect: 'they are left out, as the format has no column for them',
    },
    {
      what: 'binds of joints',
      count: bindsElsewhere(skin, skeleton),
      effect: 'vertices are bound to joints as they stand at rest',
    },
  ]);
}

/**
 * The number of rows with weight on the file's first joint, except rows with weight 1 on it alone,
 * which are read back equal.
 */
function rowsOfFirstJoint(skin: Skin, skeleton: Skeleton): number {
  const first = skeleton.jointOfSource[0]!;
  let rows = 0;
  for (let point = 0; point + 1 < skin.start.length; point++) {
    const [from, to] = [skin.start[point]!, skin.start[point + 1]!];
    const isReadAgain =
      to - from === 1 && skin.weights[from] === 1 && first === firstRoot(skeleton);
    const entries = skin.entries.subarray(from, to);
    if (!isReadAgain && entries.some((entry) => skin.paletteJoint[entry] === first)) rows++;
  }
  return rows;
}

/** The number of palette entries whose bind matrix is not that of their joint at rest. */
function bindsElsewhere(skin: Skin, skeleton: Skeleton): number {
  const characterFromJoint = jointMatrices(skeleton, skeleton.qRest);
  return skin.paletteJoint.filter((joint, entry) => {
    const world = characterFromJoint.subarray(joint * 16, joint * 16 + 16);
    const bind = skin.jointFromBind.subarray(entry * 16, entry * 16 + 16);
    return !areInverse(world, bind);
  }).length;
}

function areInverse(a: Float64Array, b: Float64Array): boolean {
  const product = new Float64Array(16);
  mat4.multiply(product, a, b);
  const bound = 1e-6 * Math.max(1, Math.hypot(a[12]!, a[13]!, a[14]!));
  return product.every((value, i) => Math.abs(value - (i % 5 === 0 ? 1 : 0)) <= bound);
}
