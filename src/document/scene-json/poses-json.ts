import { defaultLimits } from '../../core/limits.ts';
import type { NamedJoint, NamedMorph } from '../../posing/named-pose.ts';
import type { SavedPose } from '../saved-poses.ts';
import { checked, type Codec, index, listOf, numberWithin, text, textLike } from './codec.ts';
import { fields } from './fields.ts';

const { coordinate } = defaultLimits;

const value = numberWithin(-coordinate, coordinate);

/** More joints and morphs than any character has that can be opened. */
const mostValues = 65_536;

const plainJoint: NamedJoint = { name: '', dofs: '', values: [] };

const joint: Codec<NamedJoint> = checked(
  fields(plainJoint, {
    name: text,
    dofs: textLike(/^[xyzXYZshQ]{1,64}$/, 'the letters of degrees of freedom, such as "XYZ"'),
    values: listOf(value, 256),
  }),
  ({ dofs, values }) => values.length === valueCount(dofs),
  'as many values as "dofs" stands for',
);

/** A ball has four values, any other degree of freedom one. */
function valueCount(dofs: string): number {
  return dofs.length + 3 * (dofs.split('Q').length - 1);
}

const plainMorph: NamedMorph = { name: '', weight: 0 };

const plainPose: SavedPose = { id: 0, name: 'Pose', height: 0, joints: [], morphs: [] };

const pose = fields(plainPose, {
  id: index,
  name: text,
  height: numberWithin(0, coordinate),
  joints: listOf(joint, mostValues),
  morphs: listOf(fields(plainMorph, { name: text, weight: value }), mostValues),
});

/** More poses than a library is good for. */
const mostPoses = 1000;

export const posesJson: Codec<readonly SavedPose[]> = checked(
  listOf(pose, mostPoses),
  (poses) => new Set(poses.map(({ id }) => id)).size === poses.length,
  'poses whose ids differ',
);
