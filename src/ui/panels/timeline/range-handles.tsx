import type { ClipParts } from '../../../core/motion/clip-parts.ts';
import { editClip } from '../../../document/clip-edits.ts';
import type { Actor } from '../../../document/scene.ts';
import type { Editor } from '../../editor.ts';
import type { TimeWindow } from '../../timeline/time-axis.ts';
import { type TimeDrag, TimeHandle } from './time-handle.tsx';

interface RangeHandlesProperties {
  readonly editor: Editor;
  readonly actor: Actor;
  readonly clip: ClipParts;
  readonly index: number;
  readonly timeWindow: TimeWindow;
  readonly width: number;
}

/** The ends of the clip, and of the work range if there is one, which can be dragged in the ruler. */
export function RangeHandles({ actor, index, ...shared }: RangeHandlesProperties) {
  const { editor, clip, timeWindow } = shared;
  const { store, session } = editor;
  const { workRange } = session;
  const least = 1 / clip.fps;
  const work = workRange.value;
  const beginClip = (side: 'start' | 'end') => (): TimeDrag => {
    const label = side === 'start' ? 'Start of the clip' : 'End of the clip';
    const shownBefore = session.timeWindow.value;
    // What is shown would follow the clip's ends, away from the pointer.
    session.timeWindow.value = timeWindow;
    const gesture = store.begin(label);
    return {
      preview: (time) =>
        gesture.preview(
          editClip(actor.id, index, label, ({ ...parts }) =>
            side === 'start'
              ? { ...parts, start: Math.min(time, parts.end - least) }
              : { ...parts, end: Math.max(time, parts.start + least) },
          ),
        ),
      commit: () => gesture.commit(),
      cancel: () => {
        gesture.cancel();
        session.timeWindow.value = shownBefore;
      },
    };
  };
  const beginWork = (side: 0 | 1) => (): TimeDrag => {
    const before = workRange.value!;
    return {
      preview: (time) => {
        workRange.value =
          side === 0
            ? [Math.min(time, before[1] - least), before[1]]
            : [before[0], Math.max(time, before[0] + least)];
      },
      commit: () => undefined,
      cancel: () => (workRange.value = before),
    };
  };
  return (
    <>
      <TimeHandle
        {...shared}
        class="clip-end start"
        label="Start of the clip"
        time={clip.start}
        begin={beginClip('start')}
      />
      <TimeHandle
        {...shared}
        class="clip-end"
        label="End of the clip"
        time={clip.end}
        begin={beginClip('end')}
      />
      {work && (
        <>
          <TimeHandle
            {...shared}
            class="work-end start"
            label="Start of the work range"
            time={work[0]}
            begin={beginWork(0)}
          />
          <TimeHandle
            {...shared}
            class="work-end"
            label="End of the work range"
            time={work[1]}
            begin={beginWork(1)}
          />
        </>
      )}
    </>
  );
}
