import { printable } from '../../core/diagnostics.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { PlayMode } from '../../posing/playhead.ts';
import type { Editor } from '../editor.ts';
import { runKey } from '../keys.ts';
import { ClipCurves } from './clip-curves.tsx';
import { CommandButton } from './command-button.tsx';

const speeds = [0.1, 0.25, 0.5, 1, 2, 4];
const modes: Readonly<Record<PlayMode, string>> = {
  once: 'Once',
  loop: 'Loop',
  'ping-pong': 'Ping-pong',
  'go on': 'Go on',
};

/**
 * Plays clips and shows their curves, below the view, while a character has clips. Its height stays
 * the same while a character without clips is selected, so that the view keeps its size.
 */
export function Timeline({ editor }: { readonly editor: Editor }) {
  const { store, session, transport } = editor;
  const state = selectedActor(store, session);
  const { clipTime, playing, playSpeed, playMode } = session;
  const { clip, clipIndex } = transport;
  if (!state) return null;
  const { start, end } = clip ?? { start: 0, end: 0 };
  const time = clipTime.value;
  const onKey = (event: KeyboardEvent): void => {
    const { target, key } = event;
    // A list handles its own keys, and Space clicks a focused button.
    if (target instanceof HTMLSelectElement) return;
    if (key === ' ' && target instanceof HTMLButtonElement) return;
    runKey(editor, event, ['timeline']);
    if (event.defaultPrevented) event.stopPropagation();
  };
  return (
    <section class="timeline" aria-label="Timeline" onKeyDown={onKey}>
      <div class="transport">
        <select
          class="clip"
          aria-label="Clip"
          disabled={!clip}
          value={clipIndex}
          onChange={({ currentTarget }) => transport.choose(Number(currentTarget.value))}
        >
          {state.clips.map(({ name }, i) => (
            <option key={i} value={i}>
              {name}
            </option>
          ))}
        </select>
        <CommandButton editor={editor} command="clip-start" sign="|◂" />
        <CommandButton editor={editor} command="step-back" sign="◂" />
        <CommandButton
          editor={editor}
          command="play"
          class="play"
          sign={playing.value ? '❚❚' : '▶'}
        />
        <CommandButton editor={editor} command="step-on" sign="▸" />
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
      </div>
      {clip ? (
        <ClipCurves editor={editor} clip={clip} skeleton={state.character.skeleton} time={time} />
      ) : (
        <figure class="curves">
          <svg aria-hidden="true" />
          <figcaption>{printable(state.name, 80)} has no clips</figcaption>
        </figure>
      )}
    </section>
  );
}
