import { printable } from '../../core/diagnostics.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Editor } from '../editor.ts';

/** The head of the inspector: what is selected, and the courses whose look it can take. */
export function Subject({ editor }: { readonly editor: Editor }) {
  const actor = selectedActor(editor.store, editor.session);
  if (!actor) return <p class="hint">Nothing is selected.</p>;
  const { character } = actor;
  const { jointCount } = character.skeleton;
  const { pointCount } = character.mesh;
  const looks = editor.workspaces.filter(({ format }) => format === character.meta.format);
  return (
    <header class="subject">
      <h2>{printable(actor.name, 80)}</h2>
      <p>
        {jointCount} {jointCount === 1 ? 'joint' : 'joints'}, {pointCount.toLocaleString('en')}{' '}
        vertices
      </p>
      {looks.map(({ id, label }) => (
        <button
          key={id}
          type="button"
          class="chip"
          aria-pressed={editor.workspaceId.value === id}
          title={`Draw, light and handle it as ${label} does`}
          onClick={() => editor.setWorkspace(id)}
        >
          {label} look
        </button>
      ))}
    </header>
  );
}
