import '../../styles/timeline-sheet.css';
import { useEffect, useRef, useState } from 'preact/hooks';
import type { ClipParts } from '../../../core/motion/clip-parts.ts';
import type { Actor } from '../../../document/scene.ts';
import type { Editor } from '../../editor.ts';
import { addAxisGestures } from '../../timeline/axis-gestures.ts';
import { shownWindow } from '../../timeline/shown-time.ts';
import { timelineViews, type TimelineViewComponent } from '../../timeline/views.ts';
import { attempt } from '../../attempt.ts';
import { CommandButton } from '../command-button.tsx';
import { Menu } from '../menu.tsx';
import { Playhead } from './playhead.tsx';
import { RangeHandles } from './range-handles.tsx';
import { Ranges } from './ranges.tsx';
import { Ruler } from './ruler.tsx';
import { NoKeys } from './no-keys.tsx';

interface SheetProperties {
  readonly editor: Editor;
  readonly actor: Actor;
  readonly clip: ClipParts;
  readonly index: number;
}

const toggles = ['all-joints-in-timeline', 'time-in-frames', 'snap-to-frames'] as const;
const moreCommands = [
  'frame-keys',
  'frame-clip',
  'all-keys',
  'paste-keys',
  'paste-keys-reversed',
  'work-range-start',
  'work-range-end',
  'work-range-keys',
  'whole-range',
] as const;

/** The ruler of a clip, and below it the chosen view of its keys, with the line of the playhead. */
export function Sheet({ editor, actor, clip, index }: SheetProperties) {
  const { session } = editor;
  const ruler = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(0);
  const [views, setViews] = useState<Readonly<Record<string, TimelineViewComponent>>>({});
  const view = session.timelineView.value;
  const timeWindow = shownWindow(session, clip);
  const View = views[view];

  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => setWidth(entry!.contentRect.width));
    observer.observe(ruler.current!);
    return () => observer.disconnect();
  }, []);
  useEffect(() => {
    if (views[view]) return;
    const { load } = timelineViews.find(({ id }) => id === view)!;
    attempt(
      editor,
      load().then((Component) => setViews((old) => ({ ...old, [view]: Component }))),
    );
  }, [editor, view, views]);
  useEffect(
    () =>
      addAxisGestures(ruler.current!, {
        width,
        get timeWindow() {
          return shownWindow(session, clip);
        },
        showTime: (shown) => (session.timeWindow.value = shown),
      }),
    [session, clip, width],
  );

  const shared = { clip, timeWindow, width };
  return (
    <div class="keys-sheet">
      <div class="sheet-corner" role="group" aria-label="View of the timeline">
        {timelineViews.map(({ id, label }) => (
          <button
            key={id}
            type="button"
            aria-pressed={id === view}
            onClick={() => (session.timelineView.value = id)}
          >
            {label}
          </button>
        ))}
        <Menu id="timeline-menu" label="More">
          {toggles.map((command) => (
            <CommandButton
              key={command}
              editor={editor}
              command={command}
              role="menuitemcheckbox"
            />
          ))}
          <hr />
          {moreCommands.map((command) => (
            <CommandButton key={command} editor={editor} command={command} role="menuitem" />
          ))}
        </Menu>
      </div>
      <Ranges session={session} {...shared} />
      <Ruler editor={editor} element={ruler} {...shared}>
        <RangeHandles editor={editor} actor={actor} index={index} {...shared} />
      </Ruler>
      <div class="sheet-view">
        {View && width > 0 && <View editor={editor} actor={actor} index={index} {...shared} />}
        {clip.channels.length === 0 && <NoKeys actor={actor} />}
      </div>
      <div class="sheet-over">
        <Playhead session={session} {...shared} />
      </div>
    </div>
  );
}
