import { quat, type ReadonlyVec3 } from 'gl-matrix';
import { type Edit, editActor } from './edit.ts';
import type { Actor, ActorId, Transform } from './scene.ts';

type Position = Transform['position'];
type Rotation = Transform['rotation'];

/** How far from the origin a character can be, in scene units. */
export const farthestPlace = 1000;
/** The range of sizes, as factors. */
export const legalScales = [0.001, 1000] as const;

/** Moves, rotates or scales an actor in the scene. */
export function setTransform(id: ActorId, transform: Transform, label: string): Edit {
  return editActor(id, label, (actor) => ({ ...actor, transform }));
}

/** Fits a character to the common height, or shows it in its file's own units and place. */
export function setFitted({ id, name }: Actor, fitted: boolean): Edit {
  const label = fitted ? `Fit ${name}` : `File's own size of ${name}`;
  return editActor(id, label, (actor) => ({ ...actor, fitted }));
}

/**
 * Moves a transform along a vector of the scene.
 *
 * @param grid if not 0, each coordinate that changes becomes a multiple of it
 */
export function movedBy(start: Transform, vector: ReadonlyVec3, grid = 0): Transform {
  const position = start.position.map((from, axis) => {
    const by = vector[axis]!;
    if (by === 0) return from;
    const to = grid > 0 ? snapped(from + by, grid) : from + by;
    return Math.min(farthestPlace, Math.max(-farthestPlace, to));
  });
  return { ...start, position: position as unknown as Position };
}

/**
 * Turns a transform about an axis through its position.
 *
 * @param axis a unit vector: of the scene, or of the character's own frame if `isOwn`
 * @param angle in radians
 */
export function turnedBy(
  start: Transform,
  axis: ReadonlyVec3,
  angle: number,
  isOwn = false,
): Transform {
  // Without a turn, normalizing again would change the last bits.
  if (angle === 0) return start;
  const before = [...start.rotation] as [number, number, number, number];
  const about = quat.setAxisAngle(new Float64Array(4), axis, angle);
  const turned = isOwn
    ? quat.multiply(new Float64Array(4), before, about)
    : quat.multiply(new Float64Array(4), about, before);
  quat.normalize(turned, turned);
  return { ...start, rotation: [...turned] as unknown as Rotation };
}

/**
 * Scales a transform about its position.
 *
 * @param step if not 0, the scale becomes a multiple of it, and at least one step
 */
export function scaledBy(start: Transform, factor: number, step = 0): Transform {
  if (factor === 1 && step === 0) return start;
  const scale = start.scale * factor;
  const stepped = step > 0 ? Math.max(step, snapped(scale, step)) : scale;
  return { ...start, scale: Math.min(legalScales[1], Math.max(legalScales[0], stepped)) };
}

/** Rounds to a multiple of a step; dividing by the steps per unit gives 0.3, not 0.30000000000000004. */
export function snapped(value: number, step: number): number {
  const perUnit = 1 / step;
  const isWhole = Math.abs(perUnit - Math.round(perUnit)) < 1e-9;
  const count = Math.round(value / step);
  // Adding 0 turns -0 into 0.
  return (isWhole ? count / Math.round(perUnit) : count * step) + 0;
}

/** The angle of the turn from one transform to another about an axis of the scene, from -π to π. */
export function angleBetween(from: Transform, to: Transform, axis: ReadonlyVec3): number {
  const back = quat.conjugate(new Float64Array(4), [...from.rotation]);
  const [x, y, z, w] = quat.multiply(back, [...to.rotation], back);
  const along = x! * axis[0] + y! * axis[1] + z! * axis[2];
  const angle = 2 * Math.atan2(along, w!);
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}
