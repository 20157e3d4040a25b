import type { Pose } from '../core/pose.ts';
import type { NamedPose } from '../posing/named-pose.ts';
import { type Edit, editActor } from './edit.ts';
import type { ActorId, Scene } from './scene.ts';

export type SavedPoseId = number;

/** A pose of the library: of a whole character, or of a part of one. */
export interface SavedPose extends NamedPose {
  readonly id: SavedPoseId;
  readonly name: string;
}

/**
 * Returns a pose with an id that no other pose of the library has.
 *
 * @param stem its name, which gets a number if another pose has it
 */
export function newSavedPose({ poses }: Scene, stem: string, pose: NamedPose): SavedPose {
  const id = 1 + poses.reduce((largest, each) => Math.max(largest, each.id), 0);
  const names = poses.map(({ name }) => name);
  let name = stem;
  for (let number = 2; names.includes(name); number++) name = `${stem} ${number}`;
  const { height, joints, morphs } = pose;
  return { id, name, height, joints, morphs };
}

export function addSavedPose(pose: SavedPose): Edit {
  return {
    label: `Keep the pose ${pose.name}`,
    apply: (scene) => ({ ...scene, poses: [...scene.poses, pose] }),
  };
}

/** Changes the name or the values of a pose of the library. */
export function changeSavedPose(
  id: SavedPoseId,
  change: Partial<Omit<SavedPose, 'id'>>,
  label: string,
): Edit {
  return {
    label,
    apply: (scene) => ({
      ...scene,
      poses: scene.poses.map((pose) => (pose.id === id ? { ...pose, ...change } : pose)),
    }),
  };
}

export function removeSavedPose({ id, name }: SavedPose): Edit {
  return {
    label: `Remove the pose ${name}`,
    apply: (scene) => ({ ...scene, poses: scene.poses.filter((pose) => pose.id !== id) }),
  };
}

/** Moves a pose by a number of places in the library, as far as there are places. */
export function moveSavedPose({ id, name }: SavedPose, by: number): Edit {
  return {
    label: `Move the pose ${name}`,
    apply: (scene) => {
      const from = scene.poses.findIndex((pose) => pose.id === id);
      if (from < 0) return scene;
      const to = Math.min(Math.max(from + by, 0), scene.poses.length - 1);
      const others = scene.poses.filter((pose) => pose.id !== id);
      return { ...scene, poses: others.toSpliced(to, 0, scene.poses[from]!) };
    },
  };
}

/** Puts a character into a pose with its shape. */
export function setPoseAndShape(
  id: ActorId,
  { q, morphWeights }: Required<Pose>,
  label: string,
): Edit {
  const [ownQ, ownWeights] = [q.slice(), morphWeights.slice()];
  return editActor(id, label, (actor) => ({
    ...actor,
    q: ownQ,
    morphWeights: ownWeights,
  }));
}
