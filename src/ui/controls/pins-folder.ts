import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import {
  holdRotation,
  pinOf,
  setPinWeight,
  type ShownJoints,
  unpinJoints,
} from '../../document/pin-edits.ts';
import { type Actor, actorById } from '../../document/scene.ts';
import { shownPins } from '../../evaluation/shown-state.ts';
import { pinMiss } from '../../posing/pins/pin-miss.ts';
import type { Pin } from '../../posing/pins/pin.ts';
import type { Editor } from '../editor.ts';
import { keyedState } from '../keyed-state.ts';
import { formatSize } from '../number-text.ts';
import { type FollowChoice, followChoices, followWith } from '../pins.ts';
import { addCommandRow } from './command-row.ts';
import { jointName } from './joint-values.ts';
import { addNote } from './note.ts';
import { field } from './signal-field.ts';
import { addValueRow } from './value-row.ts';

/** Adds the pins of the selected character, each with what it holds. Returns what ends its effects. */
export function addPinsFolder(gui: GUI, editor: Editor): () => void {
  const { store, evaluations } = editor;
  const folder = gui.addFolder('Pins');
  folder.domElement.classList.add('pins');
  addCommandRow(folder, editor, 'pin');
  let list: GUI | null = null;
  let refresh: readonly (() => void)[] = [];
  let shown: readonly unknown[] = [];

  return effect(() => {
    const state = evaluations.selected()?.state;
    const next = [
      state?.id,
      state?.character,
      ...(state?.pins ?? []).map(({ joint }) => joint),
      store.scene.value.actors.map(({ id, name }) => `${id} ${name}`).join(),
    ];
    if (next.length !== shown.length || next.some((part, index) => part !== shown[index])) {
      shown = next;
      list?.destroy();
      list = folder.addFolder('');
      list.domElement.classList.add('plain');
      const pins = state?.pins ?? [];
      folder.title(pins.length > 0 ? `Pins (${pins.length})` : 'Pins');
      const rows = list;
      refresh = pins.map(({ joint }) => addPin(rows, editor, state!, joint));
      if (pins.length === 0) addNote(rows, 'A pinned joint stays while the others move.');
      else addCommandRow(rows, editor, 'unpin-all');
    }
    for (const each of refresh) each();
  });
}

/** Adds the rows of one pin; returns what updates them. */
function addPin(parent: GUI, editor: Editor, { id }: Actor, joint: number): () => void {
  const { store, session, evaluations } = editor;
  const shownNow = (): ShownJoints | undefined => {
    const state = actorById(store.scene.value, id);
    return state && shownPins(evaluations.of(state));
  };
  const stateNow = (): Actor | undefined => shownNow()?.state;
  const pinNow = (): Pin | undefined => {
    const state = stateNow();
    return state && pinOf(state, joint);
  };
  const name = jointName(stateNow()!, joint);
  const folder = parent.addFolder(name);
  folder.open(session.selectedJoint.peek() === joint);
  folder.onOpenClose((changed) => {
    if (changed === folder) session.selectedJoint.value = joint;
  });
  const holds = folder
    .add(
      field(
        () => (pinNow()?.rotation ? 'both' : 'place'),
        (kind) => {
          const own = shownNow();
          if (own) store.dispatch(holdRotation(own, joint, kind === 'both'));
        },
      ),
      'value',
      { 'Its place': 'place', 'Place and orientation': 'both' },
    )
    .name('Holds');
  const choices = followChoices(editor);
  const follows = folder
    .add(
      field<FollowChoice | null>(
        () => choiceOf(choices, pinNow()),
        (choice) => followWith(editor, joint, choice),
      ),
      'value',
      { Nobody: null, ...Object.fromEntries(choices) },
    )
    .name('Follows')
    .show(choices.size > 0);
  const weight = addValueRow(folder, {
    name: 'Weight',
    fullName: `Weight of the pin of ${name}`,
    minimum: 0,
    maximum: 1,
    isAngle: false,
    locked: false,
    legal: [0, 1],
    read: () => pinNow()?.weight ?? 0,
    keyed: () => keyedState(editor, stateNow(), 'pins', joint),
    begin: () => store.begin(`Weigh the pin of ${name}`),
    preview: (gesture, value) => gesture.preview(setPinWeight(stateNow()!, joint, value)),
    reset: () => store.dispatch(setPinWeight(stateNow()!, joint, 1)),
  });
  const remove = (): void => {
    const state = stateNow();
    if (state) store.dispatch(unpinJoints(state, [joint]));
  };
  folder.add({ remove }, 'remove').name('Unpin');
  return () => {
    holds.updateDisplay();
    follows.updateDisplay();
    weight.refresh();
    const shown = evaluations.selected();
    const miss = shown?.state.id === id ? pinMiss(shown, joint) : 0;
    folder.title(miss > 0 ? `${name}: ${formatSize(miss)} away` : name);
  };
}

/** The choice that a pin follows; lil-gui compares choices by identity. */
function choiceOf(
  choices: ReadonlyMap<string, FollowChoice>,
  pin: Pin | undefined,
): FollowChoice | null {
  for (const choice of choices.values()) {
    const { actor, joint } = pin?.follows ?? {};
    if (choice.actor === actor && choice.joint === joint) return choice;
  }
  return null;
}
