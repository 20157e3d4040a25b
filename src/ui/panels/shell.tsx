import { useEffect, useRef } from 'preact/hooks';
import { createControls } from '../controls/controls.ts';
import type { Editor } from '../editor.ts';
import { CharactersPanel } from './characters-panel.tsx';
import { HelpSheet } from './help-sheet.tsx';
import { ProblemsPanel } from './problems-panel.tsx';
import { StatusLine } from './status-line.tsx';
import { WorkspacePanel } from './workspace-panel.tsx';

/** The panel at the left: where from, what with, what went wrong. */
export function LeftPanel({ editor }: { readonly editor: Editor }) {
  return (
    <>
      <header>
        <h1>Sinew</h1>
        <p>Open, pose and understand skinned characters</p>
      </header>
      <CharactersPanel editor={editor} />
      <WorkspacePanel editor={editor} />
      <ProblemsPanel editor={editor} />
      <HelpSheet editor={editor} />
    </>
  );
}

/** The controls at the right: lil-gui makes its own elements. */
export function RightPanel({ editor }: { readonly editor: Editor }) {
  const container = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (container.current) createControls(container.current, editor);
  }, [editor]);
  return <div class="controls" ref={container} />;
}

export { StatusLine };
