import type { GroupId } from '../goals.ts';
import type { BenchOptions, GroupResult } from '../harness/group.ts';
import { frames } from './frames.ts';
import { kinematics } from './kinematics.ts';
import { readers } from './readers.ts';
import { skinning } from './skinning.ts';

type Group = (options: BenchOptions) => GroupResult | Promise<GroupResult>;

/** What `npm run bench` measures, in this order. */
export const groups: Readonly<Partial<Record<GroupId, Group>>> = {
  skinning,
  readers,
  kinematics,
  frames,
};
