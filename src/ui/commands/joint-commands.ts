import { bonesOf } from '../../core/bones.ts';
import { setPose } from '../../document/edits.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Session } from '../../document/session.ts';
import { rollJoint } from '../../posing/roll-joint.ts';
import type { Editor } from '../editor.ts';
import { hoveredOf } from '../hovered-limb.ts';
import type { Command } from './command.ts';

/** In radians, as in CS354's program. */
const rollStep = 0.1;

/** Commands that select joints and roll them. */
export const jointCommands = [
  {
    id: 'previous-joint',
    label: 'Previous joint',
    keys: [{ key: '[' }],
    run: (editor) => stepJoint(editor, -1),
  },
  {
    id: 'next-joint',
    label: 'Next joint',
    keys: [{ key: ']' }],
    run: (editor) => stepJoint(editor, 1),
  },
  {
    id: 'roll-left',
    label: 'Roll the bone to the left',
    keys: [{ key: 'ArrowLeft' }],
    context: 'bone',
    run: (editor) => rollBone(editor, 1),
  },
  {
    id: 'roll-right',
    label: 'Roll the bone to the right',
    keys: [{ key: 'ArrowRight' }],
    context: 'bone',
    run: (editor) => rollBone(editor, -1),
  },
] as const satisfies readonly Command[];

/** The joint that the arrow keys roll: the highlighted one, or else the selected one. */
export function rolledJoint(session: Session): number | null {
  return hoveredOf(session)?.joint ?? session.selectedJoint.value;
}

/** Selects the joint before or after the selected one, cyclically. */
function stepJoint({ store, session }: Editor, step: 1 | -1): void {
  const count = selectedActor(store, session)?.character.skeleton.jointCount ?? 0;
  if (count === 0) return;
  const { selectedJoint } = session;
  const from = selectedJoint.value ?? (step > 0 ? -1 : count);
  selectedJoint.value = (from + step + count) % count;
}

function rollBone({ store, session, evaluations }: Editor, direction: 1 | -1): void {
  const shown = evaluations.selected();
  const joint = rolledJoint(session);
  if (!shown || joint === null) return;
  const { id, character } = shown.state;
  const { skeleton } = character;
  const bone = hoveredOf(session)?.bone ?? bonesOf(character).find((each) => each.joint === joint);
  if (bone?.joint !== joint) return;
  const q = rollJoint(skeleton, shown.poseToEdit.q, joint, bone.vector, direction * rollStep);
  store.dispatch(setPose(id, q, `Roll ${skeleton.names[joint]!}`));
}
