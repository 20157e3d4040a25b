import type { RefObject } from 'preact';
import { keysOfRow } from '../../../timeline/row-keys.ts';
import type { RowId, TimelineRow } from '../../../timeline/rows.ts';

interface RowNamesProperties {
  readonly list: RefObject<HTMLDivElement | null>;
  readonly rows: readonly TimelineRow[];
  /** The row that Tab comes to. */
  readonly current: RowId;
  readonly isLit: (row: TimelineRow) => boolean;
  readonly onFocus: (row: TimelineRow) => void;
  readonly onClick: (row: TimelineRow, event: MouseEvent) => void;
  readonly onKey: (row: TimelineRow, event: KeyboardEvent) => void;
  readonly onFold: (row: TimelineRow, part: 'branch' | 'channels') => void;
}

/** The names of the rows, with what folds them; it scrolls the keys beside it too. */
export function RowNames({ list, rows, current, isLit, ...on }: RowNamesProperties) {
  return (
    <div class="row-names" role="treegrid" aria-label="Rows of keys" ref={list}>
      {rows.map((row) => {
        const { id, showsBranch, showsChannels } = row;
        // Whatever hides something below says so; both are open only if nothing is hidden.
        const isOpen = showsBranch === false ? false : (showsChannels ?? showsBranch);
        const count = keysOfRow(row.channels).times.length;
        return (
          <div
            key={id}
            role="row"
            data-row={id}
            class={`${row.kind} ${isLit(row) ? 'lit' : ''} ${row.axis ? `axis-${row.axis}` : ''}`}
            tabIndex={id === current ? 0 : -1}
            aria-level={row.level}
            {...(isOpen === null ? {} : { 'aria-expanded': isOpen })}
            style={{ paddingInlineStart: `${(row.level - 1) * 9 + 2}px` }}
            title={row.fullName}
            onFocus={() => on.onFocus(row)}
            onClick={(event) => on.onClick(row, event)}
            onKeyDown={(event) => on.onKey(row, event)}
          >
            <span role="gridcell" class="row-name">
              <span
                class="fold"
                aria-hidden="true"
                onClick={(event) => {
                  if (isOpen === null) return;
                  event.stopPropagation();
                  on.onFold(row, showsBranch === null ? 'channels' : 'branch');
                }}
              >
                {(showsBranch ?? showsChannels) === null
                  ? ''
                  : (showsBranch ?? showsChannels)
                    ? '▾'
                    : '▸'}
              </span>
              <span class="text">{row.label}</span>
            </span>
            <span role="gridcell" class="row-count">
              <span class="spoken">{count === 1 ? '1 key' : `${count} keys`}</span>
              {showsBranch !== null && showsChannels !== null && (
                <span
                  class="values"
                  aria-hidden="true"
                  title={showsChannels ? 'Hide its values' : 'Show its values'}
                  onClick={(event) => {
                    event.stopPropagation();
                    on.onFold(row, 'channels');
                  }}
                >
                  {showsChannels ? '⊟' : '⊞'}
                </span>
              )}
            </span>
          </div>
        );
      })}
    </div>
  );
}
