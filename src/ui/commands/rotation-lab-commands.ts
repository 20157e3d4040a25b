import { loadPart } from '../../core/failure.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { RotationForm } from '../../core/motion/convert-rotation.ts';
import type { Editor } from '../editor.ts';
import { toggleLab } from '../toggle-lab.ts';
import type { Command } from './command.ts';

/** A joint is selected and there is a clip; what can't be done with them is said when it is tried. */
const hasJoint = ({ session, transport }: Editor): boolean =>
  session.selectedJoint.value !== null && transport.clip !== undefined;

const storeAs =
  (curve: RotationForm): Command['run'] =>
  async (editor) => {
    const part = await loadPart(import('../rotation-lab/store-as.ts'));
    part.storeAs(editor, curve);
  };

/** The commands of the panel that explains rotations over time. */
export const rotationLabCommands = [
  {
    id: 'rotation-lab',
    label: 'Rotation lab: the rotation of a joint over time, in three charts',
    short: 'Rotation lab',
    isOn: ({ showsRotationLab }) => showsRotationLab.value,
    isEnabled: ({ store, session }) =>
      (selectedActor(store, session)?.character.skeleton.jointCount ?? 0) > 0,
    run: (editor) => toggleLab(editor, editor.showsRotationLab, 'animate', 'rotation-lab'),
  },
  {
    id: 'store-as-euler',
    label: 'Store the joint’s rotation as Euler angles',
    isEnabled: hasJoint,
    run: storeAs('euler'),
  },
  {
    id: 'store-as-slerp',
    label: 'Store the joint’s rotation as slerp: quaternions by the shortest arcs',
    isEnabled: hasJoint,
    run: storeAs('slerp'),
  },
  {
    id: 'store-as-squad',
    label: 'Store the joint’s rotation as squad: quaternions, smoothly',
    isEnabled: hasJoint,
    run: storeAs('squad'),
  },
  {
    id: 'insert-rotation-key',
    label: 'Insert a key of the joint’s rotation at the playhead',
    isEnabled: hasJoint,
    run: async (editor) => {
      const part = await loadPart(import('../rotation-lab/insert-rotation-key.ts'));
      part.insertRotationKey(editor);
    },
  },
] as const satisfies readonly Command[];
