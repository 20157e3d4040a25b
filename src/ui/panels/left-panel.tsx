import type { Editor } from '../editor.ts';
import { Sections } from './sections.tsx';

/** The panel on the left: characters, workspaces, joints and problems. */
export function LeftPanel({ editor }: { readonly editor: Editor }) {
  return (
    <>
      <header>
        <h1>Sinew</h1>
        <p>Open, pose and understand skinned characters</p>
      </header>
      <Sections editor={editor} place="left" />
    </>
  );
}
