import type { Editor } from '../../editor.ts';
import { snapped } from '../../timeline/shown-time.ts';
import { type TimeWindow, xOfTime } from '../../timeline/time-axis.ts';
import { timeText, timeUnit } from '../../timeline/timeline-state.ts';
import type { ClipParts } from '../../../core/motion/clip-parts.ts';

interface TimeHandleProperties {
  readonly editor: Editor;
  readonly clip: ClipParts;
  readonly timeWindow: TimeWindow;
  readonly width: number;
  readonly label: string;
  readonly class: string;
  /** In seconds. */
  readonly time: number;
  /** Where it stands, in CSS pixels, if not at its time. */
  readonly x?: number;
  /** Begins to change the time. */
  readonly begin: () => TimeDrag;
}

/** A change of a time in progress. */
export interface TimeDrag {
  preview(time: number): void;
  commit(): void;
  cancel(): void;
}

/** A time that is changed by dragging its mark, or frame by frame with the arrow keys. */
export function TimeHandle(properties: TimeHandleProperties) {
  const { editor, clip, timeWindow, width, label, time, begin } = properties;
  const { session } = editor;
  const onDown = (event: PointerEvent & { readonly currentTarget: HTMLElement }): void => {
    if (event.button !== 0) return;
    event.stopPropagation();
    const handle = event.currentTarget;
    handle.setPointerCapture(event.pointerId);
    const [start, end] = timeWindow;
    const drag = begin();
    const ending = new AbortController();
    const { signal } = ending;
    const move = ({ clientX }: PointerEvent): void => {
      const to = time + ((clientX - event.clientX) / width) * (end - start);
      drag.preview(snapped(session, clip, to));
    };
    const finish = (how: 'commit' | 'cancel'): void => {
      ending.abort();
      drag[how]();
    };
    handle.addEventListener('pointermove', move, { signal });
    handle.addEventListener('pointerup', () => finish('commit'), { signal });
    handle.addEventListener('pointercancel', () => finish('cancel'), { signal });
    const onKey = (key: KeyboardEvent): void => {
      if (key.key !== 'Escape') return;
      key.preventDefault();
      key.stopPropagation();
      finish('cancel');
    };
    window.addEventListener('keydown', onKey, { signal, capture: true });
  };
  const onKey = (event: KeyboardEvent): void => {
    const frames = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (frames === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const drag = begin();
    drag.preview(snapped(session, clip, time + frames / clip.fps));
    drag.commit();
  };
  return (
    <div
      class={`time-handle ${properties.class}`}
      role="slider"
      tabIndex={0}
      aria-label={label}
      aria-valuenow={time}
      aria-valuetext={timeText(time, clip.fps, timeUnit.value)}
      title={label}
      style={{ transform: `translateX(${properties.x ?? xOfTime(timeWindow, width, time)}px)` }}
      onPointerDown={onDown}
      onKeyDown={onKey}
    />
  );
}
