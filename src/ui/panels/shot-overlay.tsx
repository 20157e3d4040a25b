import type { Editor, Looking } from '../editor.ts';
import { isMoved, shotFrameOf, shownShot } from '../shots.ts';
import { AspectChoice } from './aspect-choice.tsx';
import { CommandButton } from './command-button.tsx';

/** The frame of the shot that is shown, with what is done with it most. */
export function ShotOverlay({ editor }: { readonly editor: Editor }) {
  const shot = shownShot(editor);
  if (!shot) return null;
  return (
    <>
      <Frames editor={editor} />
      <div class="shot-bar" role="group" aria-label={`The shot ${shot.name}`}>
        <span class="text">{shot.name}</span>
        <AspectChoice editor={editor} />
        {isMoved(editor) && <CommandButton editor={editor} command="update-shot" />}
        <CommandButton editor={editor} command="leave-shot" icon="close" />
      </div>
    </>
  );
}

/** Dims what a picture of the shot leaves out, in each of the views that are side by side. */
function Frames({ editor: { viewer, session } }: { readonly editor: Looking }) {
  const { width, height } = shotFrameOf(viewer);
  const isWhole = viewer.framing.value === null;
  const size = { width: `${width * 100}%`, height: `${height * 100}%` };
  const kind = `${isWhole ? 'whole ' : ''}${session.showThirds.value ? 'thirds' : ''}`;
  return (
    <div class="shot-frames">
      {Array.from({ length: viewer.columns }, (_, view) => (
        <div key={view}>
          <div class={`shot-frame ${kind}`} style={size} />
        </div>
      ))}
    </div>
  );
}
