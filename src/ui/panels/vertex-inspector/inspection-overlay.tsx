import '../../styles/ghost-labels.css';
import { useEffect, useState } from 'preact/hooks';
import { showInspection } from '../../../view/inspection.ts';
import { comparedOf } from '../../deform-lab/compared.ts';
import type { Editor } from '../../editor.ts';
import { ghostLabels, spreadHeights } from '../../vertex-inspector/ghost-labels.ts';
import { inspectedOf } from '../../vertex-inspector/inspected.ts';

/** In CSS pixels: a label, and the width of a view in which there is room for names. */
const [labelHeight, leastWidth] = [18, 220];
/** A label stands at the left of a place that has so much room there. */
const leastRoom = 120;

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
  // The figure of the largest difference then stands at the right.
  const isCompared = session.comparison.value !== null;
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
      {shown.map(({ text, x, isLeft }, index) => (
        <span
          key={index}
          class={(isLeft || isCompared) && x * width > leastRoom ? 'to-left' : ''}
          style={{ left: `${x * 100}%`, top: `${heights[index]!}px` }}
        >
          {text}
        </span>
      ))}
    </div>
  );
}
