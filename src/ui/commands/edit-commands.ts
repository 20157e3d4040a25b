import { resetJoints } from '../../document/edits.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import { subtreeEnd } from '../../core/subtree.ts';
import { loadPart } from '../../core/failure.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { selectedJoints } from '../../document/selected-joints.ts';
import { selectJoint } from '../../document/select-joints.ts';
import type { Editor } from '../editor.ts';
import { hasSteps, takeStep } from '../take-step.ts';
import type { Command } from './command.ts';

/** Undo and redo, and commands for characters and poses. */
export const editCommands = [
  {
    id: 'undo',
    label: 'Undo',
    keys: [{ key: 'z', control: true }],
    context: 'control',
    isEnabled: ({ store }) => store.undoLabel.value !== null,
    describe: ({ store }) => told('Undo', store.undoLabel.value),
    run: (editor) => takeStep(editor, 'Undid', () => editor.store.undo()),
  },
  {
    id: 'redo',
    label: 'Redo',
    keys: [{ key: 'z', control: true, shift: true }],
    context: 'control',
    isEnabled: ({ store }) => store.redoLabel.value !== null,
    describe: ({ store }) => told('Redo', store.redoLabel.value),
    run: (editor) => takeStep(editor, 'Redid', () => editor.store.redo()),
  },
  {
    id: 'history',
    label: 'Show the history: all steps, to go to any of them',
    short: 'History',
    keys: [{ key: 'y' }],
    isEnabled: ({ store }) => hasSteps(store),
    run: showHistory,
  },
  {
    id: 'duplicate-character',
    label: 'Duplicate the character',
    short: 'Duplicate',
    keys: [{ key: 'd', control: true }],
    context: 'control',
    run: (editor) => editor.duplicateSelected(),
  },
  {
    id: 'remove-character',
    label: 'Remove the character',
    short: 'Remove',
    keys: [{ key: 'Delete' }],
    context: 'character',
    isEnabled: ({ store, session }) => selectedActor(store, session) !== undefined,
    run: (editor) => editor.removeSelected(),
  },
  {
    id: 'reset-pose',
    label: 'Reset the pose',
    short: 'Reset all',
    keys: [{ key: 'r' }],
    run: (editor) => editor.resetAll(),
  },
  {
    id: 'reset-joint',
    label: 'Reset the joint',
    short: 'Reset joint',
    keys: [{ key: 'r', shift: true }],
    context: 'joint',
    isEnabled: hasJoint,
    run: (editor) => resetSelected(editor, (_, joint) => [joint]),
  },
  {
    id: 'reset-branch',
    label: 'Reset the joint and all below it',
    short: 'Reset branch',
    isEnabled: hasJoint,
    run: (editor) => resetSelected(editor, branchOf),
  },
  {
    id: 'cancel',
    label:
      'Cancel a drag, lay down the tool, keep one joint selected, deselect the active value, or ' +
      'stop comparing methods',
    keys: [{ key: 'Escape' }],
    run: takeBack,
  },
] as const satisfies readonly Command[];

function told(verb: string, label: string | null): string {
  return label === null ? `Nothing to ${verb.toLowerCase()}` : `${verb}: ${label}`;
}

/** Opens the list of steps and moves the focus to the present one. */
function showHistory(editor: Editor): void {
  if (!hasSteps(editor.store)) return;
  editor.showsHistory.value = true;
  // On narrow pages the inspector is a sheet.
  editor.drawer.value = 'right';
  requestAnimationFrame(() => {
    const list = document.querySelector('.history');
    list?.scrollIntoView({ block: 'end' });
    list?.querySelector<HTMLElement>('[aria-current]')?.focus();
  });
}

function hasJoint({ session }: Editor): boolean {
  return session.selectedJoint.value !== null;
}

/** @param jointsOf the joints to reset for a selected one */
function resetSelected(
  { store, session, evaluations }: Editor,
  jointsOf: (skeleton: Skeleton, joint: number) => readonly number[],
): void {
  const shown = evaluations.selected();
  const selected = selectedJoints(session);
  if (!shown || selected.length === 0) return;
  const { skeleton } = shown.state.character;
  const joints = [...new Set(selected.flatMap((joint) => jointsOf(skeleton, joint)))];
  const [first, ...others] = joints;
  const more = others.length === 0 ? '' : ` and ${others.length} more`;
  const label = `Reset ${skeleton.names[first!]!}${more}`;
  store.dispatch(resetJoints(shown.state, shown.poseToEdit.q, joints, label));
}

function branchOf(skeleton: Skeleton, joint: number): readonly number[] {
  const count = subtreeEnd(skeleton, joint) - joint;
  return Array.from({ length: count }, (_, i) => joint + i);
}

/**
 * Cancels a drag, or else lays down the tool for whole characters, or else narrows the selection to
 * one joint, or else deselects the active value, which drags would otherwise set.
 */
async function takeBack(editor: Editor): Promise<void> {
  const { store, session } = editor;
  const { placeTool, activeDof, dragText, selectedJoint, selectsSeveral, comparison } = session;
  if (store.cancelGesture()) dragText.value = null;
  else if (placeTool.value !== null) placeTool.value = null;
  else if (selectsSeveral.value || selectedJoints(session).length > 1) {
    selectsSeveral.value = false;
    selectJoint(session, selectedJoint.value);
  } else if (activeDof.value !== null) activeDof.value = null;
  else if (comparison.value) {
    const { leaveComparison } = await loadPart(import('../deform-lab/open-comparison.ts'));
    leaveComparison(editor);
  }
}
