import { keyGap } from '../../../../core/motion/edit/keys.ts';
import type { ClipParts } from '../../../../core/motion/clip-parts.ts';
import { scaleKeys } from '../../../../core/motion/edit/move-keys.ts';
import { spanOfKeys } from '../../../timeline/edit-keys.ts';
import type { Editor } from '../../../editor.ts';
import { beginKeyGesture } from '../../../timeline/key-gesture.ts';
import { type TimeWindow, xOfTime } from '../../../timeline/time-axis.ts';
import { type TimeDrag, TimeHandle } from '../time-handle.tsx';

interface ScaleBoxProperties {
  readonly editor: Editor;
  readonly clip: ClipParts;
  readonly timeWindow: TimeWindow;
  readonly width: number;
}

/**
 * A band from the first selected key to the last one; each end scales the keys about the other. An
 * end out of view has its handle at the edge.
 */
export function ScaleBox({ editor, clip, timeWindow, width }: ScaleBoxProperties) {
  const span = spanOfKeys(clip, editor.session.selectedKeys.value);
  if (!span || span[1] - span[0] < keyGap) return null;
  const [first, last] = span;
  const begin = (from: number, about: number) => (): TimeDrag => {
    const gesture = beginKeyGesture(editor, 'Scale keys');
    return {
      preview: (time) => {
        // At the other end all keys would be one.
        if (Math.abs(time - about) < keyGap) return;
        const timeFactor = (time - about) / (from - about);
        gesture?.preview((keys, selection) =>
          scaleKeys(keys, selection, { aboutTime: about, timeFactor }),
        );
      },
      commit: () => gesture?.commit(),
      cancel: () => gesture?.cancel(),
    };
  };
  const [left, right] = [first, last].map((time) => xOfTime(timeWindow, width, time)) as [
    number,
    number,
  ];
  if (right < 0 || left > width) return null;
  const shared = { editor, clip, timeWindow, width };
  return (
    <>
      <div
        class="scale-band"
        style={{ transform: `translateX(${left}px)`, width: `${right - left}px` }}
      />
      <TimeHandle
        {...shared}
        class="scale-start"
        label="First selected key: scales the others about the last one"
        time={first}
        x={Math.max(left, 0)}
        begin={begin(first, last)}
      />
      <TimeHandle
        {...shared}
        class="scale-end"
        label="Last selected key: scales the others about the first one"
        time={last}
        x={Math.min(right, width)}
        begin={begin(last, first)}
      />
    </>
  );
}
