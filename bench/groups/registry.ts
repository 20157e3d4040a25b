import type { GroupId } from '../goals.ts';
import type { BenchOptions, GroupResult } from '../harness/group.ts';
import { frames } from './frames.ts';

type Group = (options: BenchOptions) => GroupResult | Promise<GroupResult>;

/** What `npm run bench` measures, in this order. */
export const groups: Readonly<Partial<Record<GroupId, Group>>> = {
  frames,
};
