import { useRef } from 'preact/hooks';
import type { Editor } from '../../editor.ts';
import { chosenClip, frameRates, nameClip, setRange, setRate } from '../../clips.ts';
import { CommandButton } from '../command-button.tsx';

const longestName = 80;

/** A button beside the list of clips, and what it opens: the clip's name, length and frame rate. */
export function ClipSettings({ editor }: { readonly editor: Editor }) {
  const button = useRef<HTMLButtonElement>(null);
  const sheet = useRef<HTMLDivElement>(null);
  const place = (): void => {
    const isOpen = sheet.current?.matches(':popover-open') === true;
    button.current?.setAttribute('aria-expanded', String(isOpen));
    if (!isOpen || !sheet.current || !button.current) return;
    const { left, top } = button.current.getBoundingClientRect();
    const room = document.documentElement.clientWidth - sheet.current.offsetWidth - 8;
    const { style } = sheet.current;
    style.left = `${Math.max(8, Math.min(left, room))}px`;
    style.bottom = `${innerHeight - top + 4}px`;
    sheet.current.querySelector<HTMLElement>('input:not(:disabled), button')?.focus();
  };
  return (
    <>
      <button
        ref={button}
        type="button"
        title="Settings of the clip"
        aria-label="Settings of the clip"
        aria-haspopup="dialog"
        aria-expanded="false"
        popovertarget="clip-settings"
      >
        ⋯
      </button>
      <div
        ref={sheet}
        id="clip-settings"
        class="clip-settings"
        popover="auto"
        role="dialog"
        aria-label="Settings of the clip"
        onToggle={place}
        onKeyDown={(event) => event.stopPropagation()}
      >
        <Fields editor={editor} />
        <div class="buttons">
          <CommandButton editor={editor} command="new-clip" />
          <CommandButton editor={editor} command="duplicate-clip" />
          <CommandButton editor={editor} command="delete-clip" />
        </div>
        <h3>Work range</h3>
        <div class="buttons">
          <CommandButton editor={editor} command="work-range-start" sign="Start here" />
          <CommandButton editor={editor} command="work-range-end" sign="End here" />
          <CommandButton editor={editor} command="whole-range" sign="Clear" />
        </div>
        <div class="buttons">
          <CommandButton editor={editor} command="play-all" />
        </div>
      </div>
    </>
  );
}

/** What is typed stays in its field if it can't be, and a message says why. */
function Fields({ editor }: { readonly editor: Editor }) {
  const clip = chosenClip(editor)?.clip;
  const { snapsToFrames } = editor.session;
  const seconds = (side: 'start' | 'end', label: string) => (
    <label>
      {label}
      <input
        type="number"
        step="any"
        disabled={!clip}
        value={clip && Number(clip[side].toFixed(4))}
        onChange={({ currentTarget }) => setRange(editor, side, currentTarget.valueAsNumber)}
      />
    </label>
  );
  const rates = clip && !frameRates.some((rate) => rate === clip.fps) ? [clip.fps] : [];
  return (
    <div class="fields">
      <label class="wide">
        Name
        <input
          type="text"
          disabled={!clip}
          maxLength={longestName}
          autocomplete="off"
          spellcheck={false}
          value={clip?.name}
          onChange={({ currentTarget }) => nameClip(editor, currentTarget.value)}
        />
      </label>
      {seconds('start', 'Starts at (s)')}
      {seconds('end', 'Ends at (s)')}
      <label>
        Frames a second
        <select
          disabled={!clip}
          value={clip?.fps}
          onChange={({ currentTarget }) => setRate(editor, Number(currentTarget.value))}
        >
          {[...frameRates, ...rates].map((rate) => (
            <option key={rate} value={rate}>
              {rate}
            </option>
          ))}
        </select>
      </label>
      <label class="check">
        <input
          type="checkbox"
          checked={snapsToFrames.value}
          onChange={({ currentTarget }) => (snapsToFrames.value = currentTarget.checked)}
        />
        Snap to frames
      </label>
    </div>
  );
}
