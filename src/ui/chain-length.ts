import { chainLength, pathTo } from '../posing/ik/chain.ts';
import type { Looking } from './editor.ts';

type Reading = Pick<Looking, 'session' | 'evaluations'>;

/** The number of joints of a chain, and the most that there can be. */
export interface LengthOfChain {
  readonly count: number;
  readonly most: number;
}

/** How long the chain to a joint of the selected character is. */
export function chainLengthOf({ session, evaluations }: Reading, joint: number): LengthOfChain {
  const state = evaluations.selected()?.state;
  if (!state) return { count: 1, most: 1 };
  const { skeleton } = state.character;
  const count = chainLength(skeleton, joint, session.chainLength.value, state.pins);
  return { count, most: pathTo(skeleton, joint).length };
}

/** Lengthens or shortens the chain to a joint, as far as that is possible. */
export function changeChainLength(reading: Reading, joint: number, step: number): void {
  const { count, most } = chainLengthOf(reading, joint);
  const next = Math.min(most, Math.max(1, count + step));
  if (next !== count) reading.session.chainLength.value = { joint, count: next };
}
