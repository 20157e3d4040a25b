import type { Vector3 } from '../vector.ts';

/** In radians; two equal numbers lock the angle. */
export type Range = readonly [min: number, max: number];

export interface InsectJoint {
  readonly name: string;
  /** '' for the root. */
  readonly parent: string;
  /** The center of rotation when the insect is bound, in model units, in the character's space. */
  readonly position: Vector3;
  /**
   * The angles x, y, z at which the joint is bound, in radians; its frame then lies along the limb.
   */
  readonly bind: Vector3;
  /** The limits of the angles about x, y and z. */
  readonly limits: readonly [Range, Range, Range];
}

export const locked: Range = [0, 0];

/**
 * Returns the joint and its mirror image on the right, whose angles about y and z have the opposite
 * sign.
 */
export function bothSides(joint: InsectJoint): InsectJoint[] {
  const { position, bind, limits } = joint;
  const other = (name: string): string => name.replace('_l', '_r');
  const opposite = ([min, max]: Range): Range => [0 - max, 0 - min];
  return [
    joint,
    {
      name: other(joint.name),
      parent: other(joint.parent),
      position: [-position[0], position[1], position[2]],
      bind: [bind[0], 0 - bind[1], 0 - bind[2]],
      limits: [limits[0], opposite(limits[1]), opposite(limits[2])],
    },
  ];
}
