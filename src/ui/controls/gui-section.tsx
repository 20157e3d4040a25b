import GUI from 'lil-gui';
// lil-gui's package does not export its style sheet, and injecting it would write innerHTML.
import '../../../node_modules/lil-gui/dist/lil-gui.min.css';
import { useEffect, useRef } from 'preact/hooks';
import type { Editor } from '../editor.ts';
import type { SectionComponent } from '../sections.ts';
import { addSliderRoles } from './slider-role.ts';

/**
 * Returns a section whose numbers and switches are rows of lil-gui.
 *
 * @param add adds a folder; it may return a function that ends its effects
 */
export function guiSection(add: (gui: GUI, editor: Editor) => unknown): SectionComponent {
  return function GuiSection({ editor }) {
    const container = useRef<HTMLDivElement>(null);
    useEffect(() => {
      const gui = new GUI({
        container: container.current!,
        injectStyles: false,
        // Its sizes for touch are smaller than ours, and would win over them.
        touchStyles: 0, // lil-gui declares a number where it documents a boolean
      });
      const end = add(gui, editor);
      addSliderRoles(gui);
      return () => {
        if (typeof end === 'function') (end as () => void)();
        gui.destroy();
      };
    }, [editor]);
    return <div class="controls" ref={container} />;
  };
}
