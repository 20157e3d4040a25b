import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { printable } from '../../../../core/diagnostics.ts';
import { isRotationChannel } from '../../../../core/motion/clip-parts.ts';
import { sameTime } from '../../../../core/motion/edit/keys.ts';
import { toggled } from '../../../../core/motion/edit/selection.ts';
import { oneKey } from '../../../curve-editor/curve-edits.ts';
import type { CurveModel } from '../../../curve-editor/curve-model.ts';
import { besideText, exactText, tangentText } from '../../../curve-editor/key-text.ts';
import type { ShownCurve } from '../../../curve-editor/shown-curves.ts';
import { type KeyCell, typeCell } from '../../../curve-editor/typed-keys.ts';
import type { Editor } from '../../../editor.ts';
import { Extrapolations } from './extrapolations.tsx';
import { stepOfKey } from './table-steps.ts';

interface KeyTableProperties {
  readonly editor: Editor;
  readonly model: CurveModel;
}

interface Column {
  readonly cell: KeyCell;
  readonly label: string;
}

/** As many rows are in the page at once; the arrows go on to the others. */
const pageRows = 60;

/**
 * The keys of the chosen curve as a grid of numbers. Arrows go from cell to cell, Enter edits one,
 * Space selects its key.
 */
export function KeyTable({ editor, model }: KeyTableProperties) {
  const grid = useRef<HTMLTableElement>(null);
  const curve = model.curve.value;
  const fps = model.shown.value?.parts.fps ?? 30;
  const [at, setAt] = useState({ row: 0, column: 0 });
  const [isEditing, setEditing] = useState(false);
  const moves = useRef(false);
  const count = curve?.channel.keys.length ?? 0;
  const row = Math.min(at.row, Math.max(0, count - 1));
  useLayoutEffect(() => {
    if (!moves.current) return;
    moves.current = false;
    const cell = grid.current?.querySelector<HTMLElement>('[tabindex="0"]');
    cell?.focus();
    cell?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  });
  if (!curve) return null;
  const columns = columnsOf(curve);
  const column = Math.min(at.column, columns.length - 1);
  const start = Math.max(0, Math.min(row - pageRows / 2, count - pageRows));
  const selected = editor.session.selectedKeys.value.get(curve.key) ?? [];
  const isLocked = model.locked.value.has(curve.key);
  const go = (to: { row: number; column: number }): void => {
    moves.current = true;
    setAt(to);
  };
  const select = (index: number, adds: boolean): void => {
    const { session } = editor;
    const key = oneKey(curve.key, curve.channel.keys[index]!.time);
    session.selectedKeys.value = adds ? toggled(session.selectedKeys.peek(), key) : key;
  };
  const onKey = (event: KeyboardEvent): void => {
    if (isEditing || event.ctrlKey || event.metaKey || event.altKey) return;
    const to = stepOfKey(event.key, { row, column }, { rows: count, columns: columns.length });
    if (to) go(to);
    else if ((event.key === 'Enter' || event.key === 'F2') && !isLocked) {
      if (isEditable(curve, columns[column]!.cell)) setEditing(true);
    } else if (event.key === ' ') select(row, event.shiftKey);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const rows = curve.channel.keys.slice(start, start + pageRows);
  return (
    <div class="key-table">
      <table
        ref={grid}
        onKeyDown={onKey}
        role="grid"
        aria-label={`Keys of ${printable(curve.name, 60)}`}
        aria-rowcount={count + 1}
        aria-multiselectable="true"
      >
        <thead>
          <tr aria-rowindex={1}>
            {columns.map(({ cell, label }) => (
              <th key={cell} scope="col">
                {label}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((key, i) => {
            const index = start + i;
            const isSelected = selected.some((time) => sameTime(time, key.time));
            return (
              <tr key={index} aria-rowindex={index + 2} aria-selected={isSelected}>
                {columns.map(({ cell, label }, j) => {
                  const isHere = index === row && j === column;
                  return (
                    <td
                      key={cell}
                      role="gridcell"
                      tabIndex={isHere && !isEditing ? 0 : -1}
                      onClick={(event) => {
                        if (isHere && isEditing) return;
                        select(index, event.shiftKey);
                        go({ row: index, column: j });
                      }}
                      onDblClick={() => {
                        go({ row: index, column: j });
                        setEditing(!isLocked && isEditable(curve, cell));
                      }}
                    >
                      {isHere && isEditing ? (
                        <CellField
                          label={`${label} of key ${index + 1}`}
                          value={editedText(curve, index, cell, fps)}
                          onEnd={(text) => {
                            const isTaken = text === null || typeCell(editor, index, cell, text);
                            if (!isTaken) return false;
                            moves.current = true;
                            setEditing(false);
                            return true;
                          }}
                        />
                      ) : (
                        cellText(curve, index, cell, fps)
                      )}
                    </td>
                  );
                })}
              </tr>
            );
          })}
        </tbody>
      </table>
      <Extrapolations model={model} curve={curve} />
    </div>
  );
}

function columnsOf({ channel, unit }: ShownCurve): readonly Column[] {
  const times: readonly Column[] = [
    { cell: 'time', label: 'Time (s)' },
    { cell: 'frame', label: 'Frame' },
    { cell: 'value', label: unit === 'angle' ? 'Value (rad)' : 'Value' },
  ];
  if (isRotationChannel(channel)) return times;
  return [...times, { cell: 'in', label: 'In' }, { cell: 'out', label: 'Out' }];
}

function isEditable({ channel }: ShownCurve, cell: KeyCell): boolean {
  return cell !== 'value' || !isRotationChannel(channel);
}

function editedText({ channel }: ShownCurve, at: number, cell: KeyCell, fps: number): string {
  const { time } = channel.keys[at]!;
  if (cell === 'time') return exactText(time);
  if (cell === 'frame') return String(Number((time * fps).toFixed(3)));
  if (isRotationChannel(channel)) {
    return channel.keys[at]!.value.map((part) => part.toFixed(3)).join(' ');
  }
  const { value, tangentIn, tangentOut } = channel.keys[at]!;
  if (cell === 'value') return exactText(value);
  return tangentText(cell === 'in' ? tangentIn : tangentOut);
}

function cellText(curve: ShownCurve, at: number, cell: KeyCell, fps: number) {
  const text = editedText(curve, at, cell, fps);
  const { channel, unit } = curve;
  if (cell !== 'value' || isRotationChannel(channel)) return text;
  return (
    <>
      {text} <small>{besideText(channel.keys[at]!.value, unit)}</small>
    </>
  );
}

interface CellFieldProperties {
  readonly label: string;
  readonly value: string;
  /** Null leaves the cell as it was; returns false for a text that is not understood. */
  readonly onEnd: (text: string | null) => boolean;
}

function CellField({ label, value, onEnd }: CellFieldProperties) {
  const field = useRef<HTMLInputElement>(null);
  const [isWrong, setWrong] = useState(false);
  const isDone = useRef(false);
  useEffect(() => {
    field.current!.focus();
    field.current!.select();
  }, []);
  const end = (text: string | null): void => {
    if (isDone.current) return;
    isDone.current = onEnd(text === value ? null : text);
    setWrong(!isDone.current);
  };
  return (
    <input
      ref={field}
      type="text"
      aria-label={label}
      aria-invalid={isWrong}
      defaultValue={value}
      onBlur={({ currentTarget }) => {
        end(currentTarget.value);
        if (!isDone.current) end(null);
      }}
      onKeyDown={(event) => {
        if (event.key !== 'Enter' && event.key !== 'Escape') return;
        event.preventDefault();
        event.stopPropagation();
        end(event.key === 'Enter' ? event.currentTarget.value : null);
      }}
    />
  );
}
