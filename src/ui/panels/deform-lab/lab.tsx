import '../../styles/deform-lab.css';
import { comparedOf } from '../../deform-lab/compared.ts';
import type { Editor } from '../../editor.ts';
import { CommandButton } from '../command-button.tsx';
import { MethodChoices } from './method-choices.tsx';
import { MethodTable } from './method-table.tsx';
import { OfferedPoses } from './offered-poses.tsx';
import { RowSumsNote } from './row-sums-note.tsx';

/** Compares skinning methods in the pose that is shown: what to compare, how, and the numbers. */
export function Lab({ editor }: { readonly editor: Editor }) {
  const compared = comparedOf(editor);
  if (!compared) return <p class="hint">Select a character with a mesh.</p>;
  return (
    <>
      <MethodChoices editor={editor} />
      <div class="lab-buttons">
        <CommandButton editor={editor} command="compare-one-more" />
        <CommandButton editor={editor} command="comparison-layout" />
        <CommandButton editor={editor} command="difference-colors" />
        <CommandButton editor={editor} command="go-to-difference" />
      </div>
      <OfferedPoses editor={editor} />
      <MethodTable editor={editor} compared={compared} />
      <RowSumsNote editor={editor} compared={compared} />
      <div class="lab-buttons">
        <CommandButton editor={editor} command="save-comparison" />
        <CommandButton editor={editor} command="save-picture" sign="Save a picture" />
      </div>
    </>
  );
}
