import { selectedActor } from '../../document/selected-actor.ts';
import type { Editor } from '../editor.ts';
import {
  chosenSavedPose,
  keepPose,
  moveChosen,
  overwriteChosen,
  removeChosen,
} from '../saved-poses.ts';
import type { Command } from './command.ts';

const hasJoints = ({ store, session }: Editor): boolean =>
  (selectedActor(store, session)?.character.skeleton.jointCount ?? 0) > 0;

const hasSelection = (editor: Editor): boolean =>
  hasJoints(editor) && editor.session.selectedJoint.value !== null;

/** Commands for the library of poses. */
export const libraryCommands = [
  {
    id: 'keep-pose',
    label: 'Keep the pose in the library',
    short: 'Keep pose',
    isEnabled: hasJoints,
    run: (editor) => keepPose(editor, 'whole'),
  },
  {
    id: 'keep-branch',
    label: 'Keep the pose of the selected joint and all below it',
    short: 'Branch',
    isEnabled: hasSelection,
    run: (editor) => keepPose(editor, 'branch'),
  },
  {
    id: 'keep-joints',
    label: 'Keep the pose of the selected joints alone',
    short: 'Joints',
    isEnabled: hasSelection,
    run: (editor) => keepPose(editor, 'joints'),
  },
  {
    id: 'overwrite-pose',
    label: 'Overwrite the chosen pose of the library by the one that is shown',
    short: 'Overwrite',
    isEnabled: (editor) => chosenSavedPose(editor) !== undefined && hasJoints(editor),
    run: overwriteChosen,
  },
  {
    id: 'pose-earlier',
    label: 'Move the chosen pose of the library forward',
    isEnabled: (editor) => placeOfChosen(editor) > 0,
    run: (editor) => moveChosen(editor, -1),
  },
  {
    id: 'pose-later',
    label: 'Move the chosen pose of the library back',
    isEnabled: (editor) => {
      const place = placeOfChosen(editor);
      return place >= 0 && place < editor.store.scene.value.poses.length - 1;
    },
    run: (editor) => moveChosen(editor, 1),
  },
  {
    id: 'remove-pose',
    label: 'Remove the chosen pose from the library',
    isEnabled: (editor) => chosenSavedPose(editor) !== undefined,
    run: removeChosen,
  },
] as const satisfies readonly Command[];

function placeOfChosen(editor: Editor): number {
  const chosen = chosenSavedPose(editor);
  return chosen ? editor.store.scene.value.poses.indexOf(chosen) : -1;
}
