import { useEffect } from 'preact/hooks';
import { showInspection } from '../../../view/inspection.ts';
import type { Editor } from '../../editor.ts';
import { inspectedOf } from '../../vertex-inspector/inspected.ts';

/** Draws the inspected vertex over the view from the time when there first is one. */
export function InspectionOverlay({ editor }: { readonly editor: Editor }) {
  useEffect(() => {
    showInspection(editor.viewer, () => inspectedOf(editor)?.methods ?? []);
  }, [editor]);
  return null;
}
