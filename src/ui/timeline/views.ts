import type { FunctionComponent } from 'preact';
import { loadPart } from '../../core/failure.ts';
import type { ClipParts } from '../../core/motion/clip-parts.ts';
import type { Actor } from '../../document/scene.ts';
import type { TimelineView } from '../../document/session.ts';
import type { Editor } from '../editor.ts';
import type { TimeWindow } from './time-axis.ts';

/** What every view of the timeline is given. It stands below the ruler and shares its time axis. */
export interface TimelineViewProperties {
  readonly editor: Editor;
  /** The selected character. */
  readonly actor: Actor;
  readonly clip: ClipParts;
  /** The clip's index in the clips of the actor. */
  readonly index: number;
  /** What the ruler shows from left to right, in seconds. */
  readonly timeWindow: TimeWindow;
  /** Of the ruler, in CSS pixels: the part of a view to the right of the names. */
  readonly width: number;
}

export type TimelineViewComponent = FunctionComponent<TimelineViewProperties>;

interface TimelineViewRow {
  readonly id: TimelineView;
  readonly label: string;
  readonly load: () => Promise<TimelineViewComponent>;
}

/** What the timeline can show of a clip. To add a view, write its file and add a row. */
export const timelineViews: readonly TimelineViewRow[] = [
  {
    id: 'keys',
    label: 'Keys',
    load: async () =>
      (await loadPart(import('../panels/timeline/dope-sheet/dope-sheet.tsx'))).DopeSheet,
  },
  {
    id: 'curves',
    label: 'Curves',
    load: async () =>
      (await loadPart(import('../panels/timeline/curve-editor/curve-editor.tsx'))).CurveEditor,
  },
];
