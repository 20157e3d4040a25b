import { isMoved, leaveShot, removeShownShot, shownShot, takeShot, updateShot } from '../shots.ts';
import { type Command, toggle } from './command.ts';

/** Commands for shots: cameras that are saved with the scene, each with a frame. */
export const shotCommands = [
  {
    id: 'add-shot',
    label: 'Keep this view as a shot',
    short: 'Add shot',
    run: takeShot,
  },
  {
    id: 'update-shot',
    label: 'Update the shot to this view',
    short: 'Update',
    isEnabled: isMoved,
    run: updateShot,
  },
  {
    id: 'leave-shot',
    label: "Hide the shot's frame",
    short: 'Leave the shot',
    isEnabled: (editor) => shownShot(editor) !== undefined,
    run: leaveShot,
  },
  {
    id: 'remove-shot',
    label: 'Remove the shot',
    isEnabled: (editor) => shownShot(editor) !== undefined,
    run: removeShownShot,
  },
  {
    id: 'thirds',
    label: "Lines at the thirds of a shot's frame",
    short: 'Thirds',
    isOn: ({ session }) => session.showThirds.value,
    run: ({ session }) => toggle(session.showThirds),
  },
] as const satisfies readonly Command[];
