import { render } from 'preact';
import type { Editor } from '../ui/editor.ts';
import { LeftPanel, RightPanel, StatusLine } from '../ui/panels/shell.tsx';
import type { Layout } from './layout.ts';
import '@preact/signals';

/** The panels, loaded after the first picture: nothing of theirs is needed to draw it. */
export function mountPanels({ left, right, foot }: Layout, editor: Editor): void {
  render(<LeftPanel editor={editor} />, left);
  render(<RightPanel editor={editor} />, right);
  render(<StatusLine editor={editor} />, foot);
}
