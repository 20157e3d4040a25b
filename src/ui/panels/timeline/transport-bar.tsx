import { useEffect } from 'preact/hooks';
import { loadPart } from '../../../core/failure.ts';
import { selectedActor } from '../../../document/selected-actor.ts';
import type { PlayMode } from '../../../posing/playhead.ts';
import { attempt } from '../../attempt.ts';
import type { Editor } from '../../editor.ts';
import { numberedNames } from '../../numbered-names.ts';
import { CommandButton } from '../command-button.tsx';
import { ClipSettings } from './clip-settings.tsx';

const speeds = [0.1, 0.25, 0.5, 1, 2, 4];
const modes: Readonly<Record<PlayMode, string>> = {
  once: 'Once',
  loop: 'Loop',
  'ping-pong': 'Ping-pong',
  'go on': 'Go on',
};

/** Chooses clips and plays them. */
export function TransportBar({ editor }: { readonly editor: Editor }) {
  const { store, session, transport } = editor;
  const state = selectedActor(store, session);
  const { clipTime, playing, playSpeed, playMode } = session;
  const { clip, clipIndex } = transport;
  // A key that is set and a seek right after it stay in their order.
  useEffect(() => attempt(editor, loadPart(import('../../set-key.ts'))), [editor]);
  if (!state) return null;
  const { start, end } = clip ?? { start: 0, end: 0 };
  const time = clipTime.value;
  return (
    <div class="transport">
      <select
        class="clip"
        aria-label="Clip"
        disabled={!clip}
        value={clipIndex}
        onChange={({ currentTarget }) => transport.choose(Number(currentTarget.value))}
      >
        {numberedNames(state.clips.map(({ name }) => name)).map((name, i) => (
          <option key={i} value={i}>
            {name}
          </option>
        ))}
      </select>
      <ClipSettings editor={editor} />
      <CommandButton editor={editor} command="clip-start" sign="|◂" />
      <CommandButton editor={editor} command="step-back" sign="◂" />
      <CommandButton
        editor={editor}
        command="play"
        class="primary play"
        sign={playing.value ? '❚❚' : '▶'}
      />
      <CommandButton editor={editor} command="step-on" sign="▸" />
      <CommandButton editor={editor} command="set-key" class="set-key" sign="◆" />
      <CommandButton editor={editor} command="auto-key" class="auto-key" sign="●" />
      <CommandButton editor={editor} command="release-clip" sign="✕" />
      <input
        type="range"
        aria-label="Time"
        disabled={!clip}
        aria-valuetext={`${time.toFixed(2)} seconds`}
        min={start}
        max={end}
        step="any"
        value={Math.min(Math.max(time, start), end)}
        onInput={({ currentTarget }) => transport.seek(Number(currentTarget.value))}
      />
      <output>
        {time.toFixed(2)} / {end.toFixed(2)} s
      </output>
      <select
        aria-label="Speed"
        value={playSpeed.value}
        onChange={({ currentTarget }) => (playSpeed.value = Number(currentTarget.value))}
      >
        {speeds.map((speed) => (
          <option key={speed} value={speed}>
            {speed}×
          </option>
        ))}
      </select>
      <select
        aria-label="At the end"
        value={playMode.value}
        onChange={({ currentTarget }) => (playMode.value = currentTarget.value as PlayMode)}
      >
        {Object.entries(modes).map(([mode, label]) => (
          <option key={mode} value={mode}>
            {label}
          </option>
        ))}
      </select>
      <CommandButton editor={editor} command="save-movie" />
    </div>
  );
}
