import type { JointNature } from '../ik/problem.ts';

/** A user's own nature of a joint, in place of the one that was found. */
export type OwnNature = Omit<JointNature, 'jointFromNature'>;

/** What a user has decided about how a character's joints move by nature. */
export interface NatureSettings {
  /** Whether inverse kinematics keeps to natures. */
  readonly isOn: boolean;
  /** At most one for a joint. */
  readonly own: readonly OwnNature[];
}

/** Every character without own natures has these settings, so that they are identical. */
export const plainNatures: NatureSettings = { isOn: true, own: [] };
