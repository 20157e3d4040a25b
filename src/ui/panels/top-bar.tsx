import type { Editor } from '../editor.ts';
import { CommandButton } from './command-button.tsx';
import { FileMenu } from './file-menu.tsx';
import { TabList } from './tab-list.tsx';

/** The bar over the page: files, tasks, and what every task needs. */
export function TopBar({ editor }: { readonly editor: Editor }) {
  return (
    <>
      <h1>Sinew</h1>
      <FileMenu editor={editor} />
      <TabList editor={editor} />
      <div class="actions">
        <CommandButton editor={editor} command="undo" icon="undo" />
        <CommandButton editor={editor} command="redo" icon="redo" />
        <CommandButton editor={editor} command="save-picture" icon="picture" />
        <CommandButton editor={editor} command="palette" icon="search" />
        <CommandButton editor={editor} command="keys" icon="help" />
      </div>
    </>
  );
}
