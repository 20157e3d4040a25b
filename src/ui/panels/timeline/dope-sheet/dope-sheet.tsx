import { useEffect, useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { selectJoint, toggleJoint } from '../../../../document/select-joints.ts';
import { selectedJoints } from '../../../../document/selected-joints.ts';
import { addAxisGestures } from '../../../timeline/axis-gestures.ts';
import { addKeyPointer } from '../../../timeline/key-pointer.ts';
import type { KeyBox, ShownRows } from '../../../timeline/shown-rows.ts';
import { type RowId, timelineRows, type TimelineRow } from '../../../timeline/rows.ts';
import { showsAllJoints } from '../../../timeline/timeline-state.ts';
import { unkeyedRows } from '../../../timeline/unkeyed-rows.ts';
import type { TimelineViewProperties } from '../../../timeline/views.ts';
import { KeyCanvas } from './key-canvas.tsx';
import { KeyMenu, openMenuOfKeys } from './key-menu.tsx';
import { RowNames } from './row-names.tsx';
import { ScaleBox } from './scale-box.tsx';
import { walkRows } from './walk-rows.ts';

/** The keys of a clip as rows of diamonds: a row a joint, and below it a row a value. */
export function DopeSheet({ editor, actor, clip, timeWindow, width }: TimelineViewProperties) {
  const { session } = editor;
  const [turned, setTurned] = useState<ReadonlySet<string>>(new Set());
  const [current, setCurrent] = useState<RowId>('all');
  const [cursor, setCursor] = useState<{ readonly row: RowId; readonly time: number } | null>(null);
  const [box, setBox] = useState<KeyBox | null>(null);
  const [said, setSaid] = useState('');
  const names = useRef<HTMLDivElement>(null);
  const area = useRef<HTMLDivElement>(null);
  const pressed = useRef<{ readonly id: RowId; readonly top: number } | null>(null);
  const menu = useRef<HTMLDivElement>(null);
  const selected = selectedJoints(session);
  const allJoints = showsAllJoints.value;
  const rows = useMemo(
    () => timelineRows(clip, actor.character, { turned, allJoints, selected }),
    [clip, actor.character, turned, allJoints, selected.join()],
  );
  const unkeyed = useMemo(() => unkeyedRows(actor), [actor]);
  const isLit = ({ joint }: TimelineRow): boolean => joint !== null && selected.includes(joint);
  const focused = rows.some(({ id }) => id === current) ? current : 'all';

  const shown: ShownRows = {
    ...{ editor, clip, rows, timeWindow, width },
    rowHeight: rowHeight(),
    scrollTop: () => names.current!.scrollTop,
    focus: (row, time) => {
      setCurrent(row.id);
      setCursor(time === null ? null : { row: row.id, time });
      rowElement(names.current!, row.id)?.focus({ preventScroll: true });
    },
    showBox: setBox,
    openMenu: (x, y, isHeld) => openMenuOfKeys(menu.current!, x, y, isHeld),
    scroll: (pixels) => (names.current!.scrollTop += pixels),
  };
  // Listeners stay while what is shown changes.
  const living = useRef(shown);
  Object.assign(living.current, shown);
  useEffect(() => {
    const now = living.current;
    const endPointer = addKeyPointer(area.current!, now);
    const endAxes = addAxisGestures(area.current!, {
      get width() {
        return now.width;
      },
      get timeWindow() {
        return session.timeWindow.peek() ?? now.timeWindow;
      },
      showTime: (window) => (session.timeWindow.value = window),
      panAcross: (pixels) => now.scroll(-pixels),
    });
    return () => {
      endPointer();
      endAxes();
    };
  }, [session]);

  // The rows of selected joints come to the top: there they are seen if the joint was selected
  // elsewhere; a row that was pressed stays under the pointer.
  useLayoutEffect(() => {
    const list = names.current!;
    const row = pressed.current && rowElement(list, pressed.current.id);
    list.scrollTop = row ? row.offsetTop - pressed.current!.top : 0;
    pressed.current = null;
  }, [selected.join()]);

  const fold = (row: TimelineRow, part: 'branch' | 'channels'): void =>
    setTurned((old) => {
      const next = new Set(old);
      const id = `${part} ${row.id}`;
      if (!next.delete(id)) next.add(id);
      return next;
    });
  const select = ({ id, joint }: TimelineRow, isMore: boolean): void => {
    if (joint === null) return;
    const list = names.current!;
    pressed.current = { id, top: rowElement(list, id)!.offsetTop - list.scrollTop };
    if (isMore) toggleJoint(session, joint);
    else selectJoint(session, joint);
  };
  const picture = { rows, timeWindow, width, rowHeight: shown.rowHeight, unkeyed, isLit, cursor };
  return (
    <div class="dope">
      <RowNames
        list={names}
        rows={rows}
        current={focused}
        isLit={isLit}
        onFold={fold}
        onFocus={({ id }) => setCurrent(id)}
        onClick={(row, { shiftKey, ctrlKey, metaKey }) =>
          select(row, shiftKey || ctrlKey || metaKey)
        }
        onKey={(row, event) =>
          walkRows({ ...shown, row, cursor, fold, select, say: setSaid }, event)
        }
      />
      <div class="dope-keys" ref={area}>
        <KeyCanvas names={names} picture={{ ...picture, selection: session.selectedKeys.value }} />
        <ScaleBox editor={editor} clip={clip} timeWindow={timeWindow} width={width} />
        {box && (
          <div
            class="key-box"
            style={{
              left: `${box[0]}px`,
              top: `${box[1]}px`,
              width: `${box[2] - box[0]}px`,
              height: `${box[3] - box[1]}px`,
            }}
          />
        )}
      </div>
      <KeyMenu editor={editor} element={menu} />
      <p class="spoken" role="status">
        {said}
      </p>
    </div>
  );
}

/** Fingers need higher rows. In CSS pixels, as the style sheet has them. */
function rowHeight(): number {
  return matchMedia('(pointer: coarse)').matches ? 44 : 24;
}

function rowElement(list: HTMLElement, id: RowId): HTMLElement | null {
  return list.querySelector<HTMLElement>(`[data-row="${CSS.escape(id)}"]`);
}
