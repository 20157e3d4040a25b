import { motionViewOf, type TrailJoint } from '../document/motion-view.ts';
import { selectedActor } from '../document/selected-actor.ts';
import { selectedJoints } from '../document/selected-joints.ts';
import { attempt } from './attempt.ts';
import type { Editor } from './editor.ts';
import { changeTrails } from './motion-display.ts';

/** Whether all selected joints have a trail whatever is selected. */
export function showsTrail({ store, session }: Editor): boolean {
  const kept = motionViewOf(session).trailJoints.value;
  const selected = selectedTrails({ store, session });
  return selected.length > 0 && selected.every((each) => kept.some((one) => isSame(one, each)));
}

/** Keeps the trails of the selected joints in the view, or lets them go. */
export function toggleTrail(editor: Editor): void {
  const { trailJoints } = motionViewOf(editor.session);
  const selected = selectedTrails(editor);
  const others = trailJoints.value.filter((one) => !selected.some((each) => isSame(one, each)));
  const keeps = !showsTrail(editor);
  trailJoints.value = keeps ? [...others, ...selected] : others;
  if (keeps) attempt(editor, changeTrails(editor, { isOn: true }));
}

/** The names of the joints whose trails are kept, by character. */
export function keptTrailNames({ store, session }: Editor): readonly string[] {
  return motionViewOf(session).trailJoints.value.flatMap(({ actorId, joint }) => {
    const actor = store.scene.value.actors.find(({ id }) => id === actorId);
    return actor?.character.skeleton.names[joint] ?? [];
  });
}

function selectedTrails({
  store,
  session,
}: Pick<Editor, 'store' | 'session'>): readonly TrailJoint[] {
  const actorId = selectedActor(store, session)?.id;
  if (actorId === undefined) return [];
  return selectedJoints(session).map((joint) => ({ actorId, joint }));
}

function isSame(a: TrailJoint, b: TrailJoint): boolean {
  return a.actorId === b.actorId && a.joint === b.joint;
}
