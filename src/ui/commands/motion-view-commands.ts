import { motionViewOf } from '../../document/motion-view.ts';
import { selectedJoints } from '../../document/selected-joints.ts';
import { attempt } from '../attempt.ts';
import type { Editor } from '../editor.ts';
import { changeGhosts, changeTrails } from '../motion-display.ts';
import { showsTrail, toggleTrail } from '../trail-joints.ts';
import type { Command } from './command.ts';

/** Commands that show what is before and after the present moment of a clip. */
export const motionViewCommands = [
  {
    id: 'ghosts',
    label: 'Ghosts of the character before and after the present moment',
    short: 'Ghosts',
    isOn: ({ session }) => motionViewOf(session).ghosts.value.isOn,
    run: (editor) => toggle(editor, 'ghosts'),
  },
  {
    id: 'trails',
    label: 'Trails of the motion of the selected joints',
    short: 'Trails',
    isOn: ({ session }) => motionViewOf(session).trails.value.isOn,
    run: (editor) => toggle(editor, 'trails'),
  },
  {
    id: 'show-trail',
    label: 'Keep the trail of the selected joints in the view, or let it go',
    short: 'Keep the trail of the selection',
    isOn: showsTrail,
    isEnabled: ({ session }) => selectedJoints(session).length > 0,
    run: toggleTrail,
  },
] as const satisfies readonly Command[];

function toggle(editor: Editor, part: 'ghosts' | 'trails'): void {
  const isOn = !motionViewOf(editor.session)[part].value.isOn;
  const change = part === 'ghosts' ? changeGhosts : changeTrails;
  attempt(editor, change(editor, { isOn }));
  if (isOn && !editor.transport.isBound) editor.transport.seek(editor.session.clipTime.value);
}
