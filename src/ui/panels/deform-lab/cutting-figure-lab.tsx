import '../../styles/cutting-figure.css';
import { useEffect, useMemo } from 'preact/hooks';
import { runCommand } from '../../commands/command.ts';
import { commandOf } from '../../commands/registry.ts';
import { CuttingFigure } from '../../deform-lab/cutting-figure.ts';
import { cuttingSettings } from '../../deform-lab/cutting-settings.ts';
import type { Editor } from '../../editor.ts';
import { CuttingControls } from './cutting-controls.tsx';
import { CuttingDrawing } from './cutting-drawing.tsx';

/** Shows what blending is for: the outlines of a bend under three methods, in one plane. */
export function CuttingFigureLab({ editor }: { readonly editor: Editor }) {
  const live = useMemo(() => new CuttingFigure(editor), [editor]);
  useEffect(() => () => live.dispose(), [live]);
  const figure = cuttingSettings(editor.session).figure.value;
  if (!figure) return <p class="hint">The selected character has no skin around a joint to cut.</p>;
  return (
    <>
      <p class="about">
        <strong>{figure.characterName}</strong>, cut at {figure.jointName}. Another joint: select
        it.
      </p>
      <CuttingDrawing editor={editor} figure={figure} />
      <CuttingControls editor={editor} />
      <div class="row">
        {(['save-figure-svg', 'save-figure-png'] as const).map((id) => (
          <button key={id} type="button" onClick={() => runCommand(commandOf(id), editor)}>
            {commandOf(id).short}
          </button>
        ))}
      </div>
    </>
  );
}
