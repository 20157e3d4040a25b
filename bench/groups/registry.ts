import type { GroupId } from '../goals.ts';
import type { BenchOptions, GroupResult } from '../harness/group.ts';
import { clipEdits } from './clip-edits.ts';
import { commandLine } from './command-line.ts';
import { firstFrame } from './first-frame.ts';
import { frames } from './frames.ts';
import { inverseKinematics } from './inverse-kinematics.ts';
import { kinematics } from './kinematics.ts';
import { memory } from './memory.ts';
import { readers } from './readers.ts';
import { scaling } from './scaling.ts';
import { skinning } from './skinning.ts';
import { steadyState } from './steady-state.ts';

type Group = (options: BenchOptions) => GroupResult | Promise<GroupResult>;

/** What `npm run bench` measures, in this order. */
export const groups: Readonly<Record<GroupId, Group>> = {
  'steady-state': steadyState,
  skinning,
  readers,
  memory,
  kinematics,
  'inverse-kinematics': inverseKinematics,
  'clip-edits': clipEdits,
  'command-line': commandLine,
  'first-frame': firstFrame,
  frames,
  scaling,
};

/** The groups that run without being named. */
export function usualGroups(long: boolean): GroupId[] {
  const all = Object.keys(groups) as GroupId[];
  return long ? all : all.filter((id) => id !== 'scaling');
}
