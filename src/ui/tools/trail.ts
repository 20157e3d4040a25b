import { trailKeysOf } from '../trail-keys-shown.ts';
import type { Tool } from '../tool.ts';

/** A left drag on a key of a motion trail moves the pose at the key's time. */
export const trailTool: Tool = {
  id: 'trail',
  poses: true,
  press(place, button, { session }) {
    return button === 0 ? (trailKeysOf(session)?.press(place) ?? null) : null;
  },
};
