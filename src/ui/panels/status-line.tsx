import { printable } from '../../core/diagnostics.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Actor } from '../../document/scene.ts';
import { kernelById, kernelOf } from '../../skinning/registry.ts';
import type { Editor } from '../editor.ts';
import { CommandButton } from './command-button.tsx';

/** One line about what is shown, and about the last action. */
export function StatusLine({ editor }: { readonly editor: Editor }) {
  const { session, viewer, notice } = editor;
  const state = selectedActor(editor.store, editor.session);
  const problems = session.problems.value.length;
  const found = session.verification.value;
  return (
    <footer class="status">
      {state && (
        <>
          <strong>{printable(state.character.name, 80)}</strong>
          <span>{state.character.skeleton.jointCount} joints</span>
          <span>{state.character.mesh.pointCount.toLocaleString('en')} vertices</span>
          <span>{methodText(editor, state)}</span>
          <span>pose {viewer.poseMilliseconds.value.toFixed(1)} ms</span>
        </>
      )}
      {found && (
        <span>|GPU − CPU| {found.position === 0 ? '0' : found.position.toExponential(1)}</span>
      )}
      {problems > 0 && (
        <span class="warning">
          {problems} {problems === 1 ? 'problem' : 'problems'}
        </span>
      )}
      <output class="notice" title={notice.value}>
        {notice.value}
      </output>
      <CommandButton editor={editor} command="bone-mode" class="bone-mode" />
    </footer>
  );
}

/** The method that the picture shows, and the one that it stands in for. */
function methodText({ evaluations }: Editor, state: Actor): string {
  const chosen = kernelOf(state);
  const shown = kernelById(evaluations.of(state).method.id);
  return shown === chosen ? chosen.label : `${shown.label}, in place of ${chosen.label}`;
}
