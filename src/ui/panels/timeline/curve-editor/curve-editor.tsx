import { clipFor } from '../../../../core/motion/clip.ts';
import type { TimelineViewProperties } from '../../../timeline/views.ts';
import { ClipCurves } from '../clip-curves.tsx';

/** The curves of the selected joints. */
export function CurveEditor({ editor, actor, clip }: TimelineViewProperties) {
  return (
    <ClipCurves
      editor={editor}
      clip={clipFor(clip, actor.character)}
      skeleton={actor.character.skeleton}
      time={editor.session.clipTime.value}
    />
  );
}
