import { dofSize, DofKind, type Skeleton } from '../../core/skeleton.ts';

/**
 * Sets a joint's slides along x, y and z. Returns false if it lacks one that would have to move.
 *
 * @param values those of the joint in q
 */
export function setSlides(
  skeleton: Skeleton,
  joint: number,
  values: Float64Array,
  position: readonly [number, number, number],
): boolean {
  const left = [...position];
  visitSlides(skeleton, joint, (axis, at) => {
    values[at] = position[axis]!;
    left[axis] = 0;
  });
  return left.every((value) => value === 0);
}

/** Returns how far a joint's slides move it along x, y and z. */
export function slidesOf(
  skeleton: Skeleton,
  joint: number,
  values: Float64Array,
): [number, number, number] {
  const position: [number, number, number] = [0, 0, 0];
  visitSlides(skeleton, joint, (axis, at) => (position[axis] = values[at]!));
  return position;
}

/** @param visit gets the axis of each slide along one, and where its value is among the joint's */
function visitSlides(
  { dofStart, dofKind, dofAxis }: Skeleton,
  joint: number,
  visit: (axis: 0 | 1 | 2, at: number) => void,
): void {
  let at = 0;
  for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
    const kind = dofKind[dof] as DofKind;
    const axis = dofAxis.subarray(dof * 3, dof * 3 + 3).indexOf(1);
    if (kind === DofKind.slide && axis >= 0) visit(axis as 0 | 1 | 2, at);
    at += dofSize[kind];
  }
}
