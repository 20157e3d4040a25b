import type { Character } from '../core/character.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { type Document, selectedCharacter } from './document.ts';
import type { Session } from './session.ts';

/**
 * Drops from the session what the document no longer has: joints and bones of another skeleton, a
 * clip that is not there, playing without a bound clip. It runs with every change of the document,
 * undo and redo too, so that nothing that reads both has to ask.
 */
export function reconcile(session: Session, before: Document, after: Document): void {
  const [old, now] = [selectedCharacter(before), selectedCharacter(after)];
  if (old === now) return;
  if (!haveSameJoints(old?.character, now?.character)) dropJoints(session);
  const { hoveredBone, clipIndex, playing } = session;
  const bone = hoveredBone.value;
  if (bone && !now?.character.bones.includes(bone)) hoveredBone.value = null;
  if (!now?.character.clips[clipIndex.value]) clipIndex.value = 0;
  if ((now?.clip ?? null) === null) playing.value = false;
}

function dropJoints(session: Session): void {
  session.selectedJoint.value = null;
  session.hoveredJoint.value = null;
  session.hoveredBone.value = null;
  session.hoverPlace.value = null;
  session.activeDof.value = null;
}

/** Whether an index of a joint, or of a value in q, means the same in both. */
function haveSameJoints(a: Character | undefined, b: Character | undefined): boolean {
  if (!a || !b) return false;
  return a.skeleton === b.skeleton || jointsOf(a.skeleton) === jointsOf(b.skeleton);
}

function jointsOf({ names, parents, dofStart, dofKind, dofAxis }: Skeleton): string {
  return JSON.stringify([names, ...[parents, dofStart, dofKind, dofAxis].map((each) => [...each])]);
}
