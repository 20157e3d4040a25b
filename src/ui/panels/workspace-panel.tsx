import type { Courses, Looking, PageState } from '../editor.ts';
import type { WorkspaceId } from '../workspace.ts';

/** The menu of workspaces, with undo and redo beside it. */
export function WorkspacePanel({ editor }: { readonly editor: Looking & Courses & PageState }) {
  const { store, workspaces, workspaceId, helpOpen } = editor;
  const undo = store.undoLabel.value;
  const redo = store.redoLabel.value;
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
        <button
          type="button"
          disabled={undo === null}
          title={undo === null ? 'Nothing to undo' : `Undo: ${undo} (Ctrl/Cmd+Z)`}
          onClick={() => store.undo()}
        >
          Undo
        </button>
        <button
          type="button"
          disabled={redo === null}
          title={redo === null ? 'Nothing to redo' : `Redo: ${redo} (Ctrl/Cmd+Shift+Z)`}
          onClick={() => store.redo()}
        >
          Redo
        </button>
        <button type="button" title="Keys (?)" onClick={() => (helpOpen.value = true)}>
          Keys
        </button>
      </div>
    </section>
  );
}
