import { loadPart } from '../core/failure.ts';
import type { FileEntry } from '../formats/format.ts';
import { attempt } from './attempt.ts';
import type { Editor } from './editor.ts';
import { copiedPose, tellCopied } from './pose-clipboard.ts';

/**
 * Copies the pose when the browser copies and no text is selected, and opens pasted files or, as
 * text, a pose: with Shift as well, mirrored.
 */
export function listenToClipboard(editor: Editor): void {
  let isMirrored = false;
  window.addEventListener('keydown', ({ shiftKey }) => (isMirrored = shiftKey), true);
  window.addEventListener('keyup', ({ shiftKey }) => (isMirrored = shiftKey), true);
  window.addEventListener('copy', (event) => {
    if (isText(event.target) || window.getSelection()?.isCollapsed === false) return;
    const copied = copiedPose(editor);
    if (!copied) return;
    event.clipboardData?.setData('text/plain', copied.text);
    event.preventDefault();
    tellCopied(editor, copied);
  });
  window.addEventListener('paste', (event) => {
    if (isText(event.target)) return;
    const files = Array.from(event.clipboardData?.files ?? []);
    const text = event.clipboardData?.getData('text/plain').trim() ?? '';
    if (files.length > 0) attempt(editor, editor.openFiles(list(files), 'ask'));
    else if (text.startsWith('{')) attempt(editor, paste(editor, text, isMirrored));
  });
}

async function paste(editor: Editor, text: string, isMirrored: boolean): Promise<void> {
  const { pasteText } = await loadPart(import('./paste-pose.ts'));
  pasteText(editor, text, isMirrored);
}

async function list(files: readonly File[]): Promise<readonly FileEntry[]> {
  const { fileEntry } = await loadPart(import('./file-entry.ts'));
  return Promise.all(files.map((file) => fileEntry(file)));
}

/** Whether an element has text of its own, which the browser's own commands copy and paste. */
function isText(target: EventTarget | null): boolean {
  return target instanceof HTMLInputElement || target instanceof HTMLTextAreaElement;
}
