import { assert } from '../core/assert.ts';
import { jointRange } from '../core/pose.ts';
import type { NormalsId } from '../core/skin.ts';
import type { MethodId } from '../skinning/method.ts';
import { type Edit, editActor } from './edit.ts';
import type { Actor, ActorId } from './scene.ts';

/**
 * Sets one value of a character's pose. An edit applies to the pose that is shown. If a clip is
 * bound, what the edit changes is shown instead of the clip's values (see `hold-edits.ts`).
 *
 * @param shown (qCount) the pose that is shown
 */
export function setValue(
  id: ActorId,
  shown: Float64Array,
  index: number,
  value: number,
  label: string,
): Edit {
  assert(index >= 0 && index < shown.length, 'an index of q');
  const q = shown.slice();
  q[index] = value;
  return setPose(id, q, label);
}

/** Replaces a character's whole pose. */
export function setPose(id: ActorId, q: Float64Array, label = 'Set the pose'): Edit {
  const own = q.slice();
  return editActor(id, label, (actor) => {
    assert(own.length === actor.q.length, 'a pose of the same skeleton');
    return { ...actor, q: own };
  });
}

/** Restores the file's pose and shape. */
export function resetPose(id: ActorId): Edit {
  return editActor(id, 'Reset the pose', (actor) => ({
    ...actor,
    q: actor.character.skeleton.qRest.slice(),
    morphWeights: new Float64Array(actor.morphWeights.length),
  }));
}

/** Restores the file pose of some joints; the others stay as they are shown. */
export function resetJoints(
  { id, character: { skeleton } }: Actor,
  shown: Float64Array,
  joints: readonly number[],
  label: string,
): Edit {
  const q = shown.slice();
  for (const joint of joints) {
    const [from, to] = jointRange(skeleton, joint);
    q.set(skeleton.qRest.subarray(from, to), from);
  }
  return setPose(id, q, label);
}

/** @param shown (morphCount) the weights that are shown */
export function setMorphWeight(
  id: ActorId,
  shown: Float64Array,
  index: number,
  weight: number,
  label: string,
): Edit {
  assert(index >= 0 && index < shown.length, 'a morph of the character');
  const morphWeights = shown.slice();
  morphWeights[index] = weight;
  return editActor(id, label, (actor) => ({ ...actor, morphWeights }));
}

/** Binds a clip, which then determines the values that it animates, or unbinds it (null). */
export function bindClip(id: ActorId, clip: number | null): Edit {
  return editActor(id, clip === null ? 'Let the clip go' : 'Bind a clip', (actor) => {
    assert(clip === null || clip < actor.clips.length, 'a clip of the character');
    return { ...actor, clip, unkeyed: null };
  });
}

export function setMethod(id: ActorId, method: MethodId): Edit {
  return editActor(id, 'Change the skinning method', (actor) => ({ ...actor, method }));
}

export function setNormals(id: ActorId, normals: NormalsId): Edit {
  return editActor(id, 'Change how normals follow', (actor) => ({ ...actor, normals }));
}

export function setNormalizeWeights(id: ActorId, normalizeWeights: boolean): Edit {
  const label = normalizeWeights ? 'Normalize weights' : 'Use weights as in the file';
  return editActor(id, label, (actor) => ({ ...actor, normalizeWeights }));
}

/** Gives an actor another name; its character keeps its own. */
export function renameActor({ id, name: old }: Actor, name: string): Edit {
  return editActor(id, `Rename ${old}`, (actor) => ({ ...actor, name }));
}

/** Removes an actor from the scene. */
export function removeActor({ id, name }: Actor): Edit {
  return {
    label: `Remove ${name}`,
    apply: (scene) => ({ ...scene, actors: scene.actors.filter((actor) => actor.id !== id) }),
  };
}

/** Removes all actors, shots and saved poses from the scene. */
export function removeActors(label: string): Edit {
  return { label, apply: (scene) => ({ ...scene, actors: [], shots: [], poses: [] }) };
}
