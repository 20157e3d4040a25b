import { afterEach, expect, it } from 'vitest';
import { moveKeys } from '../../../src/core/motion/edit/move-keys.ts';
import { oneKey } from '../../../src/ui/curve-editor/curve-edits.ts';
import { channelKey } from '../../../src/core/motion/targets.ts';
import { openCharacter } from '../../../src/document/open-characters.ts';
import { reconcile } from '../../../src/document/reconcile.ts';
import { Session } from '../../../src/document/session.ts';
import { Store } from '../../../src/document/store.ts';
import { Transport } from '../../../src/document/transport.ts';
import type { Editor } from '../../../src/ui/editor.ts';
import { followKeySelection } from '../../../src/ui/timeline/follow-selection.ts';
import { beginKeyGesture, editKeys } from '../../../src/ui/timeline/key-gesture.ts';
import { characterOfRig } from '../../fixtures/character-of-rig.ts';
import { rotatedTree } from '../../fixtures/rigs.ts';
import { channel, clipOf, turn } from './clip.ts';

const session = new Session();
const store = new Store((before, after) => reconcile(session, before, after));
const editor = { store, session, transport: new Transport(store, session) } as Editor;
const curve = channel(turn(0, 0), [0, 1, 2]);
const key = channelKey(curve.target!);
const character = { ...characterOfRig(rotatedTree()), clips: [clipOf([curve])] };
store.dispatch(openCharacter(null, character, 'linear-blend'));
const selected = () => session.selectedKeys.value.get(key);
const moveBy = (seconds: number): void =>
  editKeys(editor, 'Move keys', (clip, selection) => moveKeys(clip, selection, { seconds }));

let end = followKeySelection(editor);
afterEach(() => {
  end();
  end = followKeySelection(editor);
});

it('brings back the keys that were selected before a step that undo takes back', () => {
  session.selectedKeys.value = oneKey(key, 1);
  moveBy(0.25);
  moveBy(0.25);
  expect(selected()).toEqual([1.5]);
  store.undo();
  expect(selected()).toEqual([1.25]);
  store.undo();
  expect(selected()).toEqual([1]);
  store.redo();
  expect(selected()).toEqual([1.25]);
  store.undo();
});

it('leaves a selection that goes with the clip as it is', () => {
  moveBy(0.5);
  session.selectedKeys.value = oneKey(key, 2);
  expect(selected()).toEqual([2]);
  store.undo();
  store.redo();
  expect(selected()).toEqual([2]);
  store.undo();
});

it('follows a gesture and its cancellation', () => {
  session.selectedKeys.value = oneKey(key, 2);
  const gesture = beginKeyGesture(editor, 'Move keys')!;
  gesture.preview((clip, selection) => moveKeys(clip, selection, { seconds: 3 }));
  expect(selected()).toEqual([5]);
  gesture.cancel();
  expect(selected()).toEqual([2]);
});
