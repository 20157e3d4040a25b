import { selectedActor } from '../../document/selected-actor.ts';
import type { PlayMode } from '../../posing/playhead.ts';
import type { Looking, Posing } from '../editor.ts';
import { ClipCurves } from './clip-curves.tsx';

const speeds = [0.1, 0.25, 0.5, 1, 2, 4];
const modes: Readonly<Record<PlayMode, string>> = {
  once: 'Once',
  loop: 'Loop',
  'ping-pong': 'Ping-pong',
  'go on': 'Go on',
};

/** Below the view, where the character has clips: plays them and shows their curves. */
export function Timeline({ editor }: { readonly editor: Looking & Posing }) {
  const { store, session, transport } = editor;
  const state = selectedActor(store, session);
  const { clipTime, playing, playSpeed, playMode } = session;
  const { clip, clipIndex } = transport;
  if (!state || !clip) return null;
  const { start, end } = clip;
  const time = clipTime.value;
  const bound = state.clip !== null;
  const onKey = (event: KeyboardEvent): void => {
    const { target } = event;
    const actions: Record<string, () => void> = {
      ArrowLeft: () => transport.step(-1),
      ArrowRight: () => transport.step(1),
      Home: () => transport.seek(start),
      End: () => transport.seek(end),
      // Of a button it is a click.
      ...(target instanceof HTMLInputElement ? { ' ': () => transport.togglePlay() } : {}),
    };
    const action = target instanceof HTMLSelectElement ? undefined : actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  };
  const button = (label: string, text: string, run: () => void, disabled = false) => (
    <button type="button" aria-label={label} title={label} disabled={disabled} onClick={run}>
      {text}
    </button>
  );
  return (
    <section class="timeline" aria-label="Timeline" onKeyDown={onKey}>
      <div class="transport">
        <select
          aria-label="Clip"
          value={clipIndex}
          onChange={({ currentTarget }) => transport.choose(Number(currentTarget.value))}
        >
          {state.clips.map(({ name }, i) => (
            <option key={i} value={i}>
              {name}
            </option>
          ))}
        </select>
        {button('To the start', '|◂', () => transport.seek(start))}
        {button('Step back', '◂', () => transport.step(-1))}
        <button
          type="button"
          class="play"
          aria-label={playing.value ? 'Pause' : 'Play'}
          title={`${playing.value ? 'Pause' : 'Play'} (p)`}
          onClick={() => transport.togglePlay()}
        >
          {playing.value ? '❚❚' : '▶'}
        </button>
        {button('Step on', '▸', () => transport.step(1))}
        {button('Own pose: let the clip go', '✕', () => transport.release(), !bound)}
        <input
          type="range"
          aria-label="Time"
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
      <ClipCurves editor={editor} clip={clip} skeleton={state.character.skeleton} time={time} />
    </section>
  );
}
