import { batch } from '@preact/signals-core';
import type { Character } from '../core/character.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { type Actor, type ActorId, actorById, type Scene } from './scene.ts';
import type { Session } from './session.ts';

/**
 * Removes from the session whatever the scene no longer has: a removed actor's selection, joints
 * and bones of another skeleton, a clip that does not exist, playback without a bound clip, the
 * verification of another actor, the frame of a removed shot. It runs with every change of the scene, including undo and redo,
 * so that code that reads both does not need to check.
 */
export function reconcile(session: Session, before: Scene, after: Scene): void {
  const { selectedActorId, playing, shownShot } = session;
  const old = actorById(before, selectedActorId.value);
  // Select an actor that has just come by opening or undo; otherwise any remaining one will do.
  const came = after.actors.find(({ id }) => !actorById(before, id));
  const now = came ?? actorById(after, selectedActorId.value) ?? after.actors.at(-1);
  selectedActorId.value = now?.id ?? null;
  if (old !== now) fitActor(session, old, now);
  if (!after.actors.some(({ clip }) => clip !== null)) playing.value = false;
  showUnkeyed(session, before, after);
  if (!after.shots.some(({ id }) => id === shownShot.value)) shownShot.value = null;
}

/** Pauses at the moment of an edit over a clip, when it is made and when undo brings it back. */
function showUnkeyed({ playing, clipTime }: Session, before: Scene, after: Scene): void {
  const changed = after.actors.find(
    ({ id, unkeyed }) => unkeyed && unkeyed !== actorById(before, id)?.unkeyed,
  );
  if (!changed?.unkeyed) return;
  playing.value = false;
  clipTime.value = changed.unkeyed.time;
}

/** Selects another actor of the scene. */
export function selectActor(session: Session, scene: Scene, id: ActorId): void {
  const { selectedActorId } = session;
  if (id === selectedActorId.value) return;
  batch(() => {
    selectedActorId.value = id;
    dropJoints(session);
    fitActor(session, undefined, actorById(scene, id));
  });
}

function fitActor(session: Session, old?: Actor, now?: Actor): void {
  // A verification and a limb belong to one actor as it was opened.
  if (old?.id !== now?.id || old?.character !== now?.character) {
    session.verification.value = null;
    session.hoveredLimb.value = null;
    session.hoveredPoint.value = null;
    session.markedPoint.value = null;
    session.inspectedPoint.value = null;
  }
  if (!haveSameJoints(old?.character, now?.character)) dropJoints(session);
  const { clipIndex } = session;
  if (!now?.clips[clipIndex.value]) clipIndex.value = 0;
}

/** Deselects the joint, bone and degree of freedom. */
export function dropJoints(session: Session): void {
  session.selectedJoint.value = null;
  session.jointGroup.value = [];
  session.mirroredJoints.value = [];
  session.hoveredLimb.value = null;
  session.hoveredHandle.value = null;
  session.hoverPlace.value = null;
  session.activeDof.value = null;
  session.chainLength.value = null;
  session.shownChain.value = null;
  session.ikSketch.value = null;
}

/** Whether indices of joints and of values in q mean the same in both. */
function haveSameJoints(a: Character | undefined, b: Character | undefined): boolean {
  if (!a || !b) return false;
  return a.skeleton === b.skeleton || jointsOf(a.skeleton) === jointsOf(b.skeleton);
}

function jointsOf({ names, parents, dofStart, dofKind, dofAxis }: Skeleton): string {
  return JSON.stringify([names, ...[parents, dofStart, dofKind, dofAxis].map((each) => [...each])]);
}
