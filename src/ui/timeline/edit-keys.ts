import type { ClipParts } from '../../core/motion/clip-parts.ts';
import { copyKeys, pasteKeys } from '../../core/motion/edit/copy-keys.ts';
import { moveKeys } from '../../core/motion/edit/move-keys.ts';
import { removeKeys } from '../../core/motion/edit/remove-keys.ts';
import { keysWithin, selectedIn } from '../../core/motion/edit/selection.ts';
import { type KeySelection, noKeys } from '../../core/motion/key-selection.ts';
import { channelKey } from '../../core/motion/targets.ts';
import { curveModel } from '../curve-editor/curve-model.ts';
import type { Editor } from '../editor.ts';
import { chosenClip } from '../clips.ts';
import { editKeys } from './key-gesture.ts';
import { framing } from './time-axis.ts';
import { copiedKeys } from './timeline-state.ts';

export function removeSelectedKeys(editor: Editor): void {
  const count = selectedCount(editor);
  editKeys(editor, count === 1 ? 'Remove a key' : `Remove ${count} keys`, (clip, selection) => ({
    clip: removeKeys(clip, selection),
    selection: noKeys,
  }));
}

export function copySelectedKeys(editor: Editor): void {
  const chosen = chosenClip(editor);
  const count = selectedCount(editor);
  // What is selected may be gone, by undo for example; then earlier copies stay.
  if (!chosen || count === 0) return;
  copiedKeys.value = copyKeys(chosen.clip, editor.session.selectedKeys.value);
  editor.notice.value = count === 1 ? 'Copied a key' : `Copied ${count} keys`;
}

export function cutSelectedKeys(editor: Editor): void {
  copySelectedKeys(editor);
  removeSelectedKeys(editor);
}

/** Pastes the copied keys at the playhead. Keys of channels that the character lacks are left out. */
export function pasteAtPlayhead(
  editor: Editor,
  { reversed }: { readonly reversed: boolean },
): void {
  const copied = copiedKeys.value;
  if (!copied) return;
  const time = editor.session.clipTime.value;
  const label = reversed ? 'Paste keys reversed' : 'Paste keys';
  editKeys(editor, label, (clip) => pasteKeys(clip, copied, time, { reversed }));
}

/** Repeats the selected keys: at the playhead or, where they stand there, a frame after themselves. */
export function duplicateKeys(editor: Editor): void {
  const chosen = chosenClip(editor);
  if (!chosen) return;
  const { session } = editor;
  const copied = copyKeys(chosen.clip, session.selectedKeys.value);
  if (copied.channels.length === 0) return;
  const playhead = session.clipTime.value;
  const isWithin = playhead >= copied.start && playhead <= copied.end;
  const time = isWithin ? copied.end + 1 / chosen.clip.fps : playhead;
  editKeys(editor, 'Duplicate keys', (clip) => pasteKeys(clip, copied, time));
}

/** Moves the selected keys by frames. */
export function nudgeKeys(editor: Editor, frames: number): void {
  editKeys(editor, 'Move keys', (clip, selection) =>
    moveKeys(clip, selection, { seconds: frames / clip.fps }),
  );
}

/** Selects the clip's keys; among curves, those that are seen and not locked. */
export function selectAllKeys(editor: Editor): void {
  const { session } = editor;
  const chosen = chosenClip(editor);
  if (session.timelineView.value === 'curves') curveModel(editor).selectAll();
  else if (chosen) session.selectedKeys.value = allKeys(chosen.clip);
}

/** The first and the last time of the selected keys, or of all, in seconds; null without any. */
export function spanOfKeys(
  clip: ClipParts,
  selection: KeySelection,
): readonly [number, number] | null {
  const times = selectedIn(clip, selection).map(({ channel, index }) => channel.keys[index]!.time);
  if (times.length === 0) return null;
  return times.reduce<readonly [number, number]>(
    ([first, last], time) => [Math.min(first, time), Math.max(last, time)],
    [Infinity, -Infinity],
  );
}

/** Shows the selected keys from edge to edge, or all keys; of curves their values too. */
export function frameKeys(editor: Editor): void {
  const chosen = chosenClip(editor);
  if (!chosen) return;
  if (editor.session.timelineView.value === 'curves') {
    curveModel(editor).frame();
    return;
  }
  const { clip } = chosen;
  const { selectedKeys, timeWindow } = editor.session;
  const span = spanOfKeys(clip, selectedKeys.value) ?? spanOfKeys(clip, allKeys(clip));
  timeWindow.value = span && framing(span);
}

/**
 * Goes to the key before or after the playhead: of the selected joint, if the clip moves one of
 * them, otherwise of the whole clip.
 */
export function goToKey(editor: Editor, direction: 1 | -1): void {
  const chosen = chosenClip(editor);
  if (!chosen) return;
  const { session, transport } = editor;
  const { skeleton } = chosen.actor.character;
  const joint = session.selectedJoint.value;
  const source = joint === null ? undefined : skeleton.sourceIndex[joint];
  const own = chosen.clip.channels.filter(
    ({ target }) => target && 'joint' in target && target.joint === source,
  );
  const channels = own.length > 0 ? own : chosen.clip.channels;
  const time = session.clipTime.value;
  const times = channels
    .flatMap(({ keys }) => keys.map((key) => key.time))
    .filter((each) => (each - time) * direction > 1e-4);
  if (times.length === 0) return;
  transport.seek(times.reduce((a, b) => (direction > 0 ? Math.min(a, b) : Math.max(a, b))));
}

/** Lets the selected keys, from the first to the last, be what is played. */
export function workRangeOfKeys(editor: Editor): void {
  const chosen = chosenClip(editor);
  const { selectedKeys, workRange } = editor.session;
  const span = chosen && spanOfKeys(chosen.clip, selectedKeys.value);
  if (span && span[1] > span[0]) workRange.value = span;
}

function allKeys(clip: ClipParts): KeySelection {
  const keys = clip.channels.flatMap(({ target }) => (target ? channelKey(target) : []));
  return keysWithin(clip, keys, [-Infinity, Infinity]);
}

function selectedCount(editor: Editor): number {
  const chosen = chosenClip(editor);
  return chosen ? selectedIn(chosen.clip, editor.session.selectedKeys.value).length : 0;
}
