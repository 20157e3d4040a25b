import { effect } from '@preact/signals-core';
import { type Actor, actorById, type Scene } from '../document/scene.ts';
import { selectedActor } from '../document/selected-actor.ts';
import { selectedJoints } from '../document/selected-joints.ts';
import { noPartner } from '../posing/symmetry/joint-pairs.ts';
import { liveSymmetry, type PoseCompletion } from '../posing/symmetry/live-symmetry.ts';
import { symmetryOf } from '../posing/symmetry/symmetry.ts';
import type { Completion } from '../document/store.ts';
import type { Editor } from './editor.ts';

type Following = Pick<Editor, 'store' | 'session' | 'evaluations'>;

const end = new WeakMap<Following['store'], () => void>();

/** Whether the selected character has a left and a right. */
export function hasSides({ store, session }: Following): boolean {
  const skeleton = selectedActor(store, session)?.character.skeleton;
  return skeleton !== undefined && symmetryOf(skeleton).sides.includes(1);
}

/** Lets every gesture that edits one side of a character edit its other side, or ends that. */
export function setLiveSymmetry(editor: Following, isOn: boolean): void {
  const { store, session } = editor;
  end.get(store)?.();
  session.liveSymmetry.value = isOn;
  end.delete(store);
  if (!isOn) return;
  const complete: Completion = (before) => completionFor(editor, before);
  // What is mirrored is held over a clip like what was edited, so this comes before.
  store.completions.unshift(complete);
  const hidePartners = showPartners(editor);
  end.set(store, () => {
    store.completions.splice(store.completions.indexOf(complete), 1);
    hidePartners();
  });
}

/** Returns what completes the scenes of one gesture, whatever tool previews them. */
function completionFor(
  { session, evaluations }: Following,
  before: Scene,
): (edited: Scene) => Scene {
  const leads = selectedJoints(session);
  const isSelected = (actor: Actor): boolean => actor.id === session.selectedActorId.value;
  // Edits begin from the pose that is shown at this moment, which a clip may have posed.
  const completions = new Map(
    before.actors.map((actor): [Actor, PoseCompletion] => {
      const base = evaluations.of(actor).poseToEdit.q.slice();
      const symmetry = symmetryOf(actor.character.skeleton);
      return [actor, liveSymmetry(symmetry, base, isSelected(actor) ? leads : [])];
    }),
  );
  return (edited) => {
    const actors = edited.actors.map((actor) => {
      const old = actorById(before, actor.id);
      const complete = old && completions.get(old);
      const isPosed = complete && actor.character === old.character && actor.q !== old.q;
      return isPosed ? { ...actor, q: complete(actor.q) } : actor;
    });
    return { ...edited, actors };
  };
}

/** Keeps the session's list of the joints that mirror the selected ones. Returns what ends it. */
function showPartners({ store, session }: Following): () => void {
  const stop = effect(() => {
    const skeleton = selectedActor(store, session)?.character.skeleton;
    const partners = skeleton && symmetryOf(skeleton).partners;
    const mirrored = selectedJoints(session)
      .map((joint) => ({ joint, partner: partners?.[joint] ?? noPartner }))
      .filter(({ joint, partner }) => partner !== noPartner && partner !== joint)
      .map(({ partner }) => partner);
    const shown = session.mirroredJoints.peek();
    const isSame = mirrored.length === shown.length && mirrored.every((j, i) => j === shown[i]);
    if (!isSame) session.mirroredJoints.value = mirrored;
  });
  return () => {
    stop();
    session.mirroredJoints.value = [];
  };
}
