import {
  type Matrix,
  multiply,
  rotationAbout,
  rotationOf,
  translation,
  type Vector,
} from './matrix.ts';

/**
 * A joint's degrees of freedom, each applied after the one before it: translate along an axis,
 * rotate about an axis, or rotate freely.
 */
export type Freedom =
  | { readonly kind: 'slide' | 'hinge'; readonly axis: Vector }
  | { readonly kind: 'ball' };

export interface Joint {
  /** Index of the parent, which may come before or after its child; -1 for a root. */
  readonly parent: number;
  readonly offset: Vector;
  /** Quaternion x, y, z, w of the rest rotation. */
  readonly rotation: Vector;
  readonly freedoms: readonly Freedom[];
}

/** values[joint][freedom]: one number for a slide or hinge, a unit quaternion for a ball. */
export type Values = readonly (readonly (readonly number[])[])[];

/**
 * The handout, part 3: a node's frame is its parent's times its own, down the tree. For each joint
 * it walks up to the root and back, so that the order of the joints cannot matter.
 */
export function characterFromJoints(joints: readonly Joint[], values: Values): Matrix[] {
  const known: (Matrix | undefined)[] = joints.map(() => undefined);
  return joints.map((_, index) => worldOf(index));

  function worldOf(index: number): Matrix {
    const path: number[] = [];
    for (let at = index; at !== -1 && !known[at]; at = joints[at]!.parent) path.push(at);
    for (const at of path.reverse()) {
      const { parent } = joints[at]!;
      const local = localMatrix(joints[at]!, values[at]!);
      known[at] = parent === -1 ? local : multiply(known[parent]!, local);
    }
    return known[index]!;
  }
}

function localMatrix(joint: Joint, values: readonly (readonly number[])[]): Matrix {
  return joint.freedoms.reduce(
    (matrix, freedom, index) => multiply(matrix, freedomMatrix(freedom, values[index]!)),
    multiply(translation(joint.offset), rotationOf(joint.rotation)),
  );
}

function freedomMatrix(freedom: Freedom, value: readonly number[]): Matrix {
  switch (freedom.kind) {
    case 'slide':
      return translation(freedom.axis.map((component) => component * value[0]!));
    case 'hinge':
      return rotationAbout(freedom.axis, value[0]!);
    case 'ball':
      return rotationOf(value);
  }
}

/**
 * The longest path from a root to a joint along the offsets; errors are measured relative to it.
 */
export function reachOf(joints: readonly Joint[]): number {
  const reach: number[] = [];
  const reachTo = (index: number): number => {
    const { parent, offset } = joints[index]!;
    return (reach[index] ??= Math.hypot(...offset) + (parent === -1 ? 0 : reachTo(parent)));
  };
  return Math.max(1, ...joints.map((_, index) => reachTo(index)));
}
