import { printable } from '../core/diagnostics.ts';
import type { ClipParts } from '../core/motion/clip-parts.ts';
import {
  addClip,
  duplicateClip,
  removeClip,
  renameClip,
  setClipFps,
  setClipRange,
} from '../document/clip-edits.ts';
import type { Actor } from '../document/scene.ts';
import { selectedActor } from '../document/selected-actor.ts';
import { shownState } from '../evaluation/shown-state.ts';
import type { Editor } from './editor.ts';

/** Frames a second that the menu of a clip offers. */
export const frameRates = [24, 25, 30, 60] as const;

/** A clip that is longer than this, in seconds, can't be typed. */
const longest = 24 * 3600;

interface ChosenClip {
  readonly actor: Actor;
  readonly index: number;
  readonly clip: ClipParts;
}

/** The bound clip of the selected character, or else the one that Play would bind. */
export function chosenClip({
  store,
  session,
  transport,
}: Pick<Editor, 'store' | 'session' | 'transport'>): ChosenClip | undefined {
  const actor = selectedActor(store, session);
  const index = transport.clipIndex;
  const clip = actor?.clips[index];
  return clip && { actor: actor, index, clip };
}

/** Makes an empty clip for the selected character, and binds it. */
export function makeClip({ store, session, evaluations, notice }: Editor): void {
  const shown = evaluations.selected();
  if (!shown) return;
  const { clips } = shown.state;
  const isAlone = store.scene.value.actors.every(
    ({ id, clip }) => clip === null || id === shown.state.id,
  );
  store.dispatch(addClip(shown.state, shownState(shown)));
  session.clipIndex.value = clips.length;
  session.playing.value = false;
  if (isAlone) session.clipTime.value = 0;
  notice.value = 'New clip: pose the character and press k';
}

export function copyClip(editor: Editor): void {
  const chosen = chosenClip(editor);
  if (!chosen) return;
  const { actor, index, clip } = chosen;
  editor.store.dispatch(duplicateClip(actor, index));
  editor.session.clipIndex.value = actor.clips.length;
  editor.notice.value = `${printable(clip.name, 40)} duplicated`;
}

export function deleteClip(editor: Editor): void {
  const { store, session, evaluations, notice } = editor;
  const chosen = chosenClip(editor);
  const shown = evaluations.selected();
  if (!chosen || !shown) return;
  const { actor, index, clip } = chosen;
  store.dispatch(removeClip(actor, index, shownState(shown)));
  session.clipIndex.value = Math.max(0, Math.min(index, actor.clips.length - 2));
  notice.value = `${printable(clip.name, 40)} deleted; Undo brings it back`;
}

export function nameClip(editor: Editor, name: string): void {
  const chosen = chosenClip(editor);
  const wanted = name.trim();
  if (!chosen || wanted === '') return;
  editor.store.dispatch(renameClip(chosen.actor, chosen.index, wanted));
}

/** Sets where the range begins or ends, in seconds; says so if that is impossible. */
export function setRange(editor: Editor, side: 'start' | 'end', seconds: number): void {
  const chosen = chosenClip(editor);
  if (!chosen) return;
  const start = side === 'start' ? seconds : chosen.clip.start;
  const end = side === 'end' ? seconds : chosen.clip.end;
  if (!Number.isFinite(seconds) || !(end > start) || end - start > longest) {
    editor.notice.value = 'A clip ends after its start';
    return;
  }
  editor.store.dispatch(setClipRange(chosen.actor, chosen.index, start, end));
}

export function setRate(editor: Editor, fps: number): void {
  const chosen = chosenClip(editor);
  if (chosen) editor.store.dispatch(setClipFps(chosen.actor, chosen.index, fps));
}

/** Lets the work range begin or end at the playhead, within the clip. */
export function setWorkRange({ session, transport, notice }: Editor, side: 'start' | 'end'): void {
  const { clip } = transport;
  if (!clip) return;
  const [from, to] = session.workRange.value ?? [clip.start, clip.end];
  const time = session.clipTime.value;
  const range: [number, number] =
    side === 'start' ? [time, to > time ? to : clip.end] : [from < time ? from : clip.start, time];
  if (!(range[1] > range[0])) {
    notice.value = 'The work range ends after its start';
    return;
  }
  session.workRange.value = range;
  notice.value = `Only ${range[0].toFixed(2)} to ${range[1].toFixed(2)} s play`;
}

/** Opens the settings beside the list of clips, as soon as their tab is there. */
export function openClipSettings({ tab }: Editor): void {
  tab.value = 'animate';
  let framesLeft = 120;
  const open = (): void => {
    const settings = document.querySelector<HTMLElement>('.clip-settings');
    settings?.showPopover();
    if (!settings && framesLeft-- > 0) requestAnimationFrame(open);
  };
  requestAnimationFrame(open);
}
