import {
  followJoint,
  holdPlace,
  pinJoints,
  pinOf,
  rotationBetween,
  unpinJoints,
  whyNoFollowing,
} from '../document/pin-edits.ts';
import { type ActorId, actorById } from '../document/scene.ts';
import { selectedActor } from '../document/selected-actor.ts';
import { selectedJoints } from '../document/selected-joints.ts';
import { shownPins } from '../evaluation/shown-state.ts';
import { gripPoint } from '../posing/pins/grip-point.ts';
import type { Editor } from './editor.ts';
import { numberedNames } from './numbered-names.ts';

/** A joint of another character, which a pin can follow. */
export interface FollowChoice {
  readonly actor: ActorId;
  readonly joint: number;
}

/** Whether every selected joint is pinned. */
export function arePinned({ store, session }: Editor): boolean {
  const state = selectedActor(store, session);
  const joints = selectedJoints(session);
  return state !== undefined && joints.length > 0 && joints.every((joint) => pinOf(state, joint));
}

/** Pins the selected joints where they are, or lets them go if all are pinned. */
export function togglePins(editor: Editor): void {
  const { store, session, evaluations, notice } = editor;
  const shown = evaluations.selected();
  const joints = selectedJoints(session);
  if (!shown || joints.length === 0) return;
  const edit = arePinned(editor) ? unpinJoints(shown.state, joints) : pinJoints(shown, joints);
  store.dispatch(edit);
  notice.value = edit.label
    .replace(/^Pin (.*)/, '$1 stays in its place')
    .replace(/^Unpin (.*)/, '$1 is free again');
}

export function unpinAll({ store, evaluations, notice }: Editor): void {
  const state = evaluations.selected()?.state;
  if (!state || state.pins.length === 0) return;
  store.dispatch(
    unpinJoints(
      state,
      state.pins.map(({ joint }) => joint),
    ),
  );
  notice.value = `All joints of ${state.name} are free again`;
}

/** The joints of the other characters, by the names under which they can be chosen. */
export function followChoices({ store, evaluations }: Editor): ReadonlyMap<string, FollowChoice> {
  const own = evaluations.selected()?.state.id;
  const { actors } = store.scene.value;
  const names = numberedNames(actors.map(({ name }) => name));
  const choices = new Map<string, FollowChoice>();
  actors.forEach(({ id, character }, at) => {
    if (id === own) return;
    character.skeleton.names.forEach((name, joint) => {
      choices.set(`${names[at]!}: ${name}`, { actor: id, joint });
    });
  });
  return choices;
}

/** Lets the pin of a joint follow another character's joint, or hold its place (null). */
export function followWith(editor: Editor, joint: number, choice: FollowChoice | null): void {
  const { store, evaluations, notice } = editor;
  const shown = evaluations.selected();
  if (!shown) return;
  if (!choice) {
    store.dispatch(holdPlace(shownPins(shown), joint));
    return;
  }
  const scene = store.scene.value;
  const { state } = shown;
  const reason = whyNoFollowing(scene, state.id, choice.actor);
  const other = actorById(scene, choice.actor);
  if (reason !== null || !other) {
    notice.value = reason ?? '';
    return;
  }
  const rotation = rotationBetween(shown, joint, evaluations.of(other), choice.joint);
  const names = [state.character, other.character].map(({ skeleton }) => skeleton.names);
  const [own, others] = [names[0]![joint]!, names[1]![choice.joint]!];
  const label = `${own} follows ${other.name}'s ${others}`;
  const point = gripPoint(other.character, choice.joint);
  const edit = followJoint(
    shownPins(shown),
    joint,
    gripPoint(state.character, joint),
    { actor: choice.actor, joint: choice.joint, point, rotation },
    label,
  );
  store.dispatch(edit);
  notice.value = label;
}
