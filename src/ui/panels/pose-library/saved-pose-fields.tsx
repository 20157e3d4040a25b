import type { SavedPose } from '../../../document/saved-poses.ts';
import type { Editor } from '../../editor.ts';
import { renameSavedPose } from '../../saved-poses.ts';
import { CommandButton } from '../command-button.tsx';

interface SavedPoseFieldsProperties {
  readonly editor: Editor;
  readonly pose: SavedPose;
}

/** What can be changed of a pose of the scene. */
export function SavedPoseFields({ editor, pose }: SavedPoseFieldsProperties) {
  return (
    <div class="fields">
      <input
        type="text"
        aria-label="Name of the pose"
        maxLength={80}
        autocomplete="off"
        spellcheck={false}
        value={pose.name}
        onChange={({ currentTarget }) => {
          renameSavedPose(editor, pose, currentTarget.value);
          currentTarget.value = pose.name; // as it is, where the new name has nothing to read
        }}
      />
      <CommandButton editor={editor} command="overwrite-pose" />
      <CommandButton editor={editor} command="pose-earlier" icon="previous" />
      <CommandButton editor={editor} command="pose-later" icon="next" />
      <CommandButton editor={editor} command="remove-pose" icon="remove" />
    </div>
  );
}
