import type { Camera } from './camera.ts';
import type { Edit } from './edit.ts';
import type { Scene } from './scene.ts';

export type AspectId = 'view' | '1:1' | '4:5' | '3:2' | '16:9' | 'A4';

/** The form of a picture. */
export interface Aspect {
  readonly id: AspectId;
  readonly label: string;
  /** Width by height; null for that of the view. */
  readonly ratio: number | null;
}

/** Every form that a shot can have. */
export const aspects: readonly Aspect[] = [
  { id: 'view', label: 'As the view', ratio: null },
  { id: '1:1', label: '1:1', ratio: 1 },
  { id: '4:5', label: '4:5', ratio: 4 / 5 },
  { id: '3:2', label: '3:2', ratio: 3 / 2 },
  { id: '16:9', label: '16:9', ratio: 16 / 9 },
  { id: 'A4', label: 'A4', ratio: 210 / 297 },
];

export type ShotId = number;

/** A saved picture of the scene: a camera and the form of what it sees. */
export interface Shot {
  readonly id: ShotId;
  readonly name: string;
  /**
   * Its field of view is that of the frame's height, so that the picture depends on no window's
   * size.
   */
  readonly camera: Camera;
  readonly aspect: AspectId;
}

/** Width by height of a shot's picture, or null for that of the view. */
export function ratioOf(shot: Shot | undefined): number | null {
  return aspects.find(({ id }) => id === shot?.aspect)?.ratio ?? null;
}

export function shotById({ shots }: Scene, id: ShotId | null): Shot | undefined {
  return shots.find((shot) => shot.id === id);
}

/** Returns a shot with an id and a name that no other shot of the scene has. */
export function newShot({ shots }: Scene, camera: Camera, aspect: AspectId): Shot {
  const id = 1 + shots.reduce((largest, shot) => Math.max(largest, shot.id), 0);
  const names = shots.map(({ name }) => name);
  let number = shots.length + 1;
  while (names.includes(`Shot ${number}`)) number++;
  return { id, name: `Shot ${number}`, camera, aspect };
}

export function addShot(shot: Shot): Edit {
  return {
    label: `Add ${shot.name}`,
    apply: (scene) => ({ ...scene, shots: [...scene.shots, shot] }),
  };
}

/** Changes some of a shot. */
export function changeShot(id: ShotId, change: Partial<Omit<Shot, 'id'>>, label: string): Edit {
  return {
    label,
    apply: (scene) => ({
      ...scene,
      shots: scene.shots.map((shot) => (shot.id === id ? { ...shot, ...change } : shot)),
    }),
  };
}

export function removeShot({ id, name }: Shot): Edit {
  return {
    label: `Remove ${name}`,
    apply: (scene) => ({ ...scene, shots: scene.shots.filter((shot) => shot.id !== id) }),
  };
}
