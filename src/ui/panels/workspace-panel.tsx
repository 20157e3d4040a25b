import type { Editor } from '../editor.ts';
import type { WorkspaceId } from '../workspace.ts';
import { CommandButton } from './command-button.tsx';

/** The menu of workspaces, with undo and redo beside it. */
export function WorkspacePanel({ editor }: { readonly editor: Editor }) {
  const { workspaces, workspaceId } = editor;
  return (
    <section class="toolbar" aria-label="Workspace and history">
      <label>
        Workspace
        <select
          value={workspaceId.value}
          onChange={({ currentTarget }) => editor.setWorkspace(currentTarget.value as WorkspaceId)}
        >
          {workspaces.map(({ id, label }) => (
            <option key={id} value={id}>
              {label}
            </option>
          ))}
        </select>
      </label>
      <div class="buttons">
        <CommandButton editor={editor} command="undo" />
        <CommandButton editor={editor} command="redo" />
        <CommandButton editor={editor} command="keys" />
      </div>
    </section>
  );
}
