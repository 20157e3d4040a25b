import type { Editor } from '../editor.ts';
import { BonePanel } from './bone-panel.tsx';
import { CharactersPanel } from './characters-panel.tsx';
import { HelpSheet } from './help-sheet.tsx';
import { JointTree } from './joint-tree.tsx';
import { ProblemsPanel } from './problems-panel.tsx';
import { WorkspacePanel } from './workspace-panel.tsx';

/** The panel at the left: where from, what with, what it is made of, what went wrong. */
export function LeftPanel({ editor }: { readonly editor: Editor }) {
  return (
    <>
      <header>
        <h1>Sinew</h1>
        <p>Open, pose and understand skinned characters</p>
      </header>
      <CharactersPanel editor={editor} />
      <ProblemsPanel editor={editor} />
      <WorkspacePanel editor={editor} />
      <JointTree editor={editor} />
      <BonePanel editor={editor} />
      <HelpSheet editor={editor} />
    </>
  );
}
