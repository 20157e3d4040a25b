import { useState } from 'preact/hooks';
import { printable } from '../../core/diagnostics.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Actor } from '../../document/scene.ts';
import { kernelById, kernelOf } from '../../skinning/registry.ts';
import type { Editor, Keeping } from '../editor.ts';
import { CommandButton } from './command-button.tsx';

/** One line: the last message, the count of problems, and figures for who wants them. */
export function StatusLine({ editor }: { readonly editor: Editor }) {
  const [open, setOpen] = useState(false);
  const { session, notice, restored, drawer } = editor;
  const problems = session.problems.value.length;
  return (
    <footer class="status">
      <output class="notice" title={notice.value}>
        {notice.value}
      </output>
      {restored.value !== '' && restored.value === notice.value && (
        <CommandButton editor={editor} command="start-fresh" />
      )}
      <Kept keeping={editor.keeping.value} />
      {problems > 0 && (
        <button type="button" class="warning" onClick={() => (drawer.value = 'right')}>
          {problems} {problems === 1 ? 'problem' : 'problems'}
        </button>
      )}
      {open && <Figures editor={editor} />}
      <button type="button" aria-expanded={open} onClick={() => setOpen(!open)}>
        Figures
      </button>
    </footer>
  );
}

/** Whether this browser has the scene as it is now, in a word that stays while that is a moment off. */
function Kept({ keeping }: { readonly keeping: Keeping }) {
  if (keeping === 'nothing') return null;
  const title =
    keeping === 'failed'
      ? 'This browser does not keep the scene; save it in a file (Ctrl/Cmd+S)'
      : 'This browser keeps the scene, and brings it back after a crash or a closed tab';
  return (
    <span class="kept" data-keeping={keeping} title={title}>
      {keeping === 'failed' ? 'Not saved' : 'Saved'}
    </span>
  );
}

/** What is shown, in numbers. */
function Figures({ editor }: { readonly editor: Editor }) {
  const { session, viewer } = editor;
  const state = selectedActor(editor.store, session);
  const found = session.verification.value;
  if (!state) return null;
  return (
    <span class="figures">
      <strong>{printable(state.name, 80)}</strong>
      <span>{state.character.skeleton.jointCount} joints</span>
      <span>{state.character.mesh.pointCount.toLocaleString('en')} vertices</span>
      <span>{methodText(editor, state)}</span>
      <span>pose {viewer.poseMilliseconds.value.toFixed(1)} ms</span>
      {found && (
        <span>
          {found.isOnCpu ? 'computed on the CPU, drawn with' : '|GPU − CPU|'}{' '}
          {found.position === 0 ? '0' : found.position.toExponential(1)}
        </span>
      )}
    </span>
  );
}

/** The method that the picture shows, and the one that it stands in for. */
function methodText({ evaluations }: Editor, state: Actor): string {
  const chosen = kernelOf(state);
  const shown = kernelById(evaluations.of(state).method.id);
  return shown === chosen ? chosen.label : `${shown.label}, in place of ${chosen.label}`;
}
