import { selectedActor } from '../../document/selected-actor.ts';
import { arePinned, togglePins, unpinAll } from '../pins.ts';
import type { Command } from './command.ts';

/** Commands that hold joints in their places and let them go. */
export const pinCommands = [
  {
    id: 'pin',
    label: 'Pin the selected joints in their places, or let them go',
    short: 'Pinned',
    keys: [{ key: 'l' }],
    isOn: arePinned,
    isEnabled: ({ session }) => session.selectedJoint.value !== null,
    run: togglePins,
  },
  {
    id: 'unpin-all',
    label: 'Let all pinned joints go',
    short: 'Unpin all',
    isEnabled: ({ store, session }) => (selectedActor(store, session)?.pins.length ?? 0) > 0,
    run: unpinAll,
  },
] as const satisfies readonly Command[];
