import type { ChannelKey } from './targets.ts';

/**
 * Selected keys of a clip: by channel, their times in seconds, increasing. Times that have no key
 * are without effect, so that a selection outlives undo.
 */
export type KeySelection = ReadonlyMap<ChannelKey, readonly number[]>;

export const noKeys: KeySelection = new Map();
