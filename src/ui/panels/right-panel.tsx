import { useEffect, useRef } from 'preact/hooks';
import { createControls } from '../controls/controls.ts';
import type { Editor } from '../editor.ts';

/** The controls on the right; lil-gui creates its own elements. */
export function RightPanel({ editor }: { readonly editor: Editor }) {
  const container = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (container.current) createControls(container.current, editor);
  }, [editor]);
  return <div class="controls" ref={container} />;
}
