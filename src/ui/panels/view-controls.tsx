import type { Editor } from '../editor.ts';
import { CommandButton } from './command-button.tsx';

/**
 * The tools at the left edge of the view, the switches at its top right, the camera and the
 * selected joints below them.
 */
export function ViewControls({ editor }: { readonly editor: Editor }) {
  const { placeTool, selectedJoint, posesBy } = editor.session;
  const hasRings = selectedJoint.value !== null && posesBy.value === 'selection';
  const isPlacing = placeTool.value === 'move' || placeTool.value === 'turn';
  return (
    <>
      <div class="view-tools" role="group" aria-label="Tools">
        <CommandButton editor={editor} command="look-tool" icon="look" />
        <CommandButton editor={editor} command="bone-mode" icon="pose" />
        <CommandButton editor={editor} command="ik-mode" icon="chain" />
        <CommandButton editor={editor} command="live-symmetry" icon="symmetry" />
        <CommandButton editor={editor} command="move-tool" icon="move" />
        <CommandButton editor={editor} command="turn-tool" icon="turn" />
        <CommandButton editor={editor} command="scale-tool" icon="scale" />
        <CommandButton editor={editor} command="first-person" icon="walk" />
        {isPlacing && <CommandButton editor={editor} command="place-axes" icon="own-axes" />}
      </div>
      <div class="view-switches" role="group" aria-label="What is shown">
        <CommandButton editor={editor} command="skin" icon="skin" />
        <CommandButton editor={editor} command="skeleton" icon="skeleton" />
        <CommandButton editor={editor} command="translucent" icon="translucent" />
        <CommandButton editor={editor} command="axes" icon="axes" />
        <CommandButton editor={editor} command="weights" icon="weights" />
        <CommandButton editor={editor} command="compare" icon="compare" />
      </div>
      {hasRings && (
        <div class="view-joint" role="group" aria-label="Selected joints">
          <CommandButton editor={editor} command="ring-axes" icon="own-axes" />
          <CommandButton editor={editor} command="select-several" icon="several" />
        </div>
      )}
      <div class="view-camera" role="group" aria-label="Camera">
        <CommandButton editor={editor} command="add-shot" icon="shot" />
        <CommandButton editor={editor} command="frame" icon="frame" />
        <CommandButton editor={editor} command="reset-camera" icon="home" />
      </div>
    </>
  );
}
