// Lets components follow the signals that they read.
import '@preact/signals';
import { render } from 'preact';
import type { Editor } from '../ui/editor.ts';
import { LeftPanel } from '../ui/panels/left-panel.tsx';
import { RightPanel } from '../ui/panels/right-panel.tsx';
import { StatusLine } from '../ui/panels/status-line.tsx';
import { ViewOverlay } from '../ui/panels/view-overlay.tsx';
import type { Layout } from './layout.ts';

/** The panels, loaded after the first picture: nothing of theirs is needed to draw it. */
export function mountPanels({ left, right, overlay, foot }: Layout, editor: Editor): void {
  render(<LeftPanel editor={editor} />, left);
  render(<RightPanel editor={editor} />, right);
  render(<ViewOverlay editor={editor} />, overlay);
  render(<StatusLine editor={editor} />, foot);
}
