import { convertTargets, labelOf } from '../../formats/registry.ts';
import { attempt } from '../attempt.ts';
import type { Editor } from '../editor.ts';
import { otherPoseFormats } from '../pose-files.ts';
import { CommandButton } from './command-button.tsx';
import { Menu } from './menu.tsx';

/** Everything that reads or writes files. */
export function FileMenu({ editor }: { readonly editor: Editor }) {
  const hasCharacter = editor.store.scene.value.actors.length > 0;
  return (
    <Menu id="file-menu" label="File">
      <CommandButton editor={editor} command="new-scene" role="menuitem" />
      <CommandButton editor={editor} command="start-fresh" role="menuitem" />
      <CommandButton editor={editor} command="open-files" role="menuitem" />
      <CommandButton editor={editor} command="open-folder" role="menuitem" />
      <CommandButton editor={editor} command="add-files" role="menuitem" />
      <hr />
      <CommandButton editor={editor} command="save-scene" role="menuitem" />
      <CommandButton editor={editor} command="save-scene-as" role="menuitem" />
      <CommandButton editor={editor} command="copy-link" role="menuitem" />
      <hr />
      {convertTargets.map((format) => (
        <button
          key={format}
          type="button"
          role="menuitem"
          disabled={!hasCharacter}
          onClick={() => attempt(editor, editor.saveAs(format))}
        >
          Save as {labelOf(format)}
        </button>
      ))}
      <CommandButton editor={editor} command="export-mesh" role="menuitem" />
      <hr />
      <CommandButton editor={editor} command="open-pose" role="menuitem" />
      <CommandButton editor={editor} command="save-pose" role="menuitem" />
      {otherPoseFormats(editor).map((format) => (
        <button
          key={format.id}
          type="button"
          role="menuitem"
          onClick={() => attempt(editor, editor.savePose(format))}
        >
          Save pose as {format.label}
        </button>
      ))}
      <CommandButton editor={editor} command="copy-pose" role="menuitem" />
      <CommandButton editor={editor} command="save-motion" role="menuitem" />
      <CommandButton editor={editor} command="save-motion-anim" role="menuitem" />
      <CommandButton editor={editor} command="choose-image" role="menuitem" />
      <hr />
      <CommandButton editor={editor} command="save-movie" role="menuitem" />
      <CommandButton editor={editor} command="check-machine" role="menuitem" />
    </Menu>
  );
}
