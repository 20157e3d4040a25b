import type { ComponentChildren, RefObject } from 'preact';
import type { ClipParts } from '../../../core/motion/clip-parts.ts';
import type { Editor } from '../../editor.ts';
import { rulerMarks } from '../../timeline/marks.ts';
import { snapped } from '../../timeline/shown-time.ts';
import { timeAtX, type TimeWindow } from '../../timeline/time-axis.ts';
import { timeUnit } from '../../timeline/timeline-state.ts';

interface RulerProperties {
  readonly editor: Editor;
  readonly clip: ClipParts;
  readonly timeWindow: TimeWindow;
  readonly width: number;
  /** What else can be dragged in it. */
  readonly children: ComponentChildren;
  readonly element: RefObject<HTMLDivElement | null>;
}

/**
 * Seconds or frames above a view of the timeline. A drag in it shows the pose of every time that it
 * passes; by keys, the slider of the transport does the same.
 */
export function Ruler(properties: RulerProperties) {
  const { editor, clip, timeWindow, width, element, children } = properties;
  const { session, transport } = editor;
  const seekAt = (event: PointerEvent): void => {
    const { left } = element.current!.getBoundingClientRect();
    const time = timeAtX(timeWindow, width, event.clientX - left);
    transport.seek(snapped(session, clip, time));
  };
  return (
    <div
      ref={element}
      class="ruler"
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        element.current!.setPointerCapture(event.pointerId);
        seekAt(event);
      }}
      onPointerMove={(event) => {
        if (element.current!.hasPointerCapture(event.pointerId) && (event.buttons & 1) === 1)
          seekAt(event);
      }}
    >
      <div class="marks" aria-hidden="true">
        {rulerMarks(timeWindow, width, clip.fps, timeUnit.value).map(({ x, text }) => (
          <span key={x} class={text ? 'labeled' : ''} style={{ left: `${x}px` }}>
            {text}
          </span>
        ))}
      </div>
      {children}
    </div>
  );
}
