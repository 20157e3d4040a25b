import '../../styles/ghost-labels.css';
import { useEffect, useState } from 'preact/hooks';
import { showInspection } from '../../../view/inspection.ts';
import { comparedOf } from '../../deform-lab/compared.ts';
import { placeOfWorst, textIsLeft, viewPlace } from '../../deform-lab/place-of-worst.ts';
import type { Editor } from '../../editor.ts';
import {
  type FigureSide,
  ghostLabels,
  spreadHeights,
  standsLeft,
} from '../../vertex-inspector/ghost-labels.ts';
import { inspectedOf } from '../../vertex-inspector/inspected.ts';

/** In CSS pixels: a label, and the width of a view in which there is room for names. */
const [labelHeight, leastWidth] = [18, 220];

/**
 * Draws the inspected vertex over the view from the time when there first is one, with the names of
 * its joints. Of views that are side by side, the first one has the names.
 */
export function InspectionOverlay({ editor }: { readonly editor: Editor }) {
  const { session, viewer } = editor;
  const [width, setWidth] = useState(0);
  const [height, setHeight] = useState(0);
  useEffect(() => {
    showInspection(viewer, () => inspectedOf(editor)?.methods ?? []);
  }, [editor, viewer]);
  const isApart = session.comparison.value?.layout === 'side by side';
  const columns = isApart ? (comparedOf(editor)?.rows.length ?? 1) : 1;
  const methods = inspectedOf(editor)?.methods ?? [];
  const labels = ghostLabels(methods, viewer.viewCamera.value, viewer.aspect);
  const shown = width < leastWidth ? [] : labels;
  const heights = spreadHeights(
    shown.map(({ y }) => y * height),
    labelHeight,
  );
  return (
    <div
      class="ghost-labels"
      // The same size again changes nothing.
      ref={(box) => {
        if (!box) return;
        setWidth(box.clientWidth);
        setHeight(box.clientHeight);
      }}
      style={{ width: `${100 / columns}%` }}
      aria-hidden="true"
    >
      {shown.map((label, index) => (
        <span
          key={index}
          class={standsLeft(label, width, figureSide(editor)) ? 'to-left' : ''}
          style={{ left: `${label.x * 100}%`, top: `${heights[index]!}px` }}
        >
          {label.text}
        </span>
      ))}
    </div>
  );
}

/** Where the figure of the largest difference stands beside the inspected vertex, in the first view. */
function figureSide(editor: Editor): FigureSide {
  const { session, viewer } = editor;
  const compared = comparedOf(editor);
  const place = compared && placeOfWorst(compared);
  if (!place || place.point !== session.inspectedPoint.value) return null;
  const isFirst = compared.rows[0]!.method === compared.worst!.method;
  if (session.comparison.value?.layout === 'side by side' && !isFirst) return null;
  const [x] = viewPlace(viewer.viewCamera.value, viewer.aspect, place.other);
  return textIsLeft(x) ? 'left' : 'right';
}
