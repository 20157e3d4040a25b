import { isRotationChannel } from '../../core/motion/clip-parts.ts';
import { channelOf } from '../../core/motion/edit/channels.ts';
import { insertKey } from '../../core/motion/edit/insert-key.ts';
import { squadTurnOnInsert } from '../../core/motion/edit/squad-turn.ts';
import type { ChannelKey } from '../../core/motion/targets.ts';
import { formatDegrees } from '../angle-text.ts';
import type { Editor } from '../editor.ts';
import { snapped } from '../timeline/shown-time.ts';
import { oneKey } from './curve-edits.ts';
import { curveModel } from './curve-model.ts';
import { keyCount, secondsText } from './drag-texts.ts';

/** A change of a rotation that nobody sees, in radians. */
const unseenTurn = 1e-4;

/** Inserts a key on a curve, or asks first if a rotation would turn elsewhere by it. */
export function insertOnCurve(editor: Editor, key: ChannelKey, at: number): void {
  const model = curveModel(editor);
  const clip = model.shown.peek()?.parts;
  const channel = clip && channelOf(clip, key);
  if (!channel) return;
  const time = snapped(editor.session, clip, at);
  const turn = isRotationChannel(channel) ? squadTurnOnInsert(channel, time) : 0;
  if (turn > unseenTurn) model.asked.value = { channel: key, time, turn };
  else insertNow(editor, key, time, turn);
}

/** Inserts the key that was asked about. */
export function insertAsked(editor: Editor): void {
  const model = curveModel(editor);
  const asked = model.asked.peek();
  model.asked.value = null;
  if (asked) insertNow(editor, asked.channel, asked.time, asked.turn);
}

function insertNow(editor: Editor, key: ChannelKey, time: number, turn: number): void {
  const model = curveModel(editor);
  const clip = model.shown.peek()?.parts;
  if (!clip) return;
  const { clip: edited, fixed } = insertKey(clip, key, time);
  if (edited === clip) {
    editor.notice.value = 'No key fits here: one is at this time, or the curve repeats itself';
    return;
  }
  model.edit('Insert a key', () => edited);
  editor.session.selectedKeys.value = oneKey(key, time);
  const said = `Key inserted at ${secondsText(time)}`;
  if (fixed.length > 0) {
    editor.notice.value = `${said}; slopes of ${keyCount(fixed.length)} are numbers now`;
  } else if (turn > unseenTurn) {
    editor.notice.value = `${said}; the joint turns by as much as ${formatDegrees(turn)} elsewhere`;
  } else editor.notice.value = said;
}

/** Inserts a key on the chosen curve at the playhead. */
export function insertAtPlayhead(editor: Editor): void {
  const { curve } = curveModel(editor);
  if (curve.peek()) insertOnCurve(editor, curve.peek()!.key, editor.session.clipTime.peek());
}
