import type { Editor } from '../editor.ts';
import { Icon } from './icon.tsx';
import { TabList } from './tab-list.tsx';

/** On a phone, the outliner and the inspector are sheets, which these buttons open and close. */
export function PhoneBar({ editor }: { readonly editor: Editor }) {
  const { drawer } = editor;
  const isOpen = drawer.value === 'left';
  return (
    <>
      <button
        type="button"
        aria-expanded={isOpen}
        onClick={() => (drawer.value = isOpen ? null : 'left')}
      >
        <Icon id="list" />
        <span>Characters</span>
      </button>
      <TabList editor={editor} folds />
    </>
  );
}
