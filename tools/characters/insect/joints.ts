import type { Vector3 } from '../vector.ts';

/** Radians; two equal numbers lock the angle. */
export type Range = readonly [min: number, max: number];

export interface InsectJoint {
  readonly name: string;
  /** '' for the root. */
  readonly parent: string;
  /** Where it turns when the insect is bound, model units, character space. */
  readonly position: Vector3;
  /** Angles x, y, z, radians, at which the insect is bound: the frame then lies along the limb. */
  readonly bind: Vector3;
  /** Of the angles about x, y and z. */
  readonly limits: readonly [Range, Range, Range];
}

export const locked: Range = [0, 0];

/** The joint and its image on the right: angles about y and z are the opposite ones there. */
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
