import { selectedActor } from '../../document/selected-actor.ts';
import { toggleLab } from '../toggle-lab.ts';
import type { Command } from './command.ts';

/** The command of the panel that explains inverse kinematics. */
export const ikLabCommands = [
  {
    id: 'ik-lab',
    label: 'IK lab: how inverse kinematics works, step by step',
    short: 'IK lab',
    isOn: ({ session }) => session.showIkLab.value,
    isEnabled: ({ store, session }) =>
      (selectedActor(store, session)?.character.skeleton.jointCount ?? 0) > 0,
    run: (editor) => toggleLab(editor, editor.session.showIkLab, 'pose', 'ik-lab'),
  },
] as const satisfies readonly Command[];
