import { useEffect, useState } from 'preact/hooks';
import type { Editor } from '../editor.ts';
import { preparing, preparingText } from '../preparing.ts';
import { CommandButton } from './command-button.tsx';

/** What takes less time, in milliseconds, ends before anyone could read of it. */
const patience = 200;

/** Says that a method is being prepared, how far that is, and what is shown meanwhile. */
export function PreparingBox({ editor }: { readonly editor: Editor }) {
  const running = preparing(editor);
  const [isLong, setIsLong] = useState(false);
  const isRunning = running.length > 0;
  useEffect(() => {
    if (!isRunning) {
      setIsLong(false);
      return;
    }
    const timer = setTimeout(() => setIsLong(true), patience);
    return () => clearTimeout(timer);
  }, [isRunning]);
  // The box of files that are being opened has the same place.
  if (!isRunning || !isLong || editor.progress.value) return null;
  const { text, part } = preparingText(running);
  return (
    <div class="progress preparing" role="status">
      <label>
        {text}
        <progress value={part} max={1} />
      </label>
      <CommandButton editor={editor} command="cancel-work" />
    </div>
  );
}
