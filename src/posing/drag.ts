import { mat4, vec3 } from 'gl-matrix';
import { assert } from '../core/assert.ts';
import { pointOnRay, type Ray } from '../core/ray.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import { followRay } from './follow-ray.ts';
import { type DofFrame, jointFrames, parentMatrix } from './joint-frames.ts';
import { coursePixelRate, knobAngle, knobPixelRate, type ViewAxes } from './mouse-turns.ts';
import { rollAxis, rollFrom } from './roll-joint.ts';
import { nearestValue, radiusAbout } from './single-value.ts';
import { turnAbout, turnJoint, type TurnStart, turnStart } from './turn-joint.ts';

/** Where the pointer is. */
export interface DragPointer {
  /** Of sight, in the character's space. */
  readonly ray: Ray;
  /** CSS pixels, x to the right and y up, from anywhere. */
  readonly x: number;
  readonly y: number;
}

/**
 * What a drag does.
 * - `follow`: the joint turns so that the grabbed point stays under the pointer.
 * - `value`: one value of q alone is set, so that the grabbed point is nearest to the pointer.
 * - `course`: the joint turns about the axis across the view and the motion, as the course's program.
 * - `roll`: the joint turns about the line to `farEnd` (joint frame), which stays.
 */
export type DragMode =
  | { readonly kind: 'follow' }
  | { readonly kind: 'value'; readonly index: number }
  | { readonly kind: 'course' }
  | { readonly kind: 'roll'; readonly farEnd: readonly [number, number, number] };

export interface DragStart {
  readonly skeleton: Skeleton;
  /** (qCount) the pose at the start; never written. */
  readonly q: Float64Array;
  readonly joint: number;
  /** Of the joint or of what hangs on it, in the character's space. */
  readonly grabbed: readonly [number, number, number];
  readonly pointer: DragPointer;
  readonly view: ViewAxes;
  readonly mode: DragMode;
  /**
   * A point nearer than this to what it would turn about does not follow (a pixel would be a large
   * turn); the motion of the pointer turns instead. Character units; 8 pixels' worth is good.
   */
  readonly leastReach?: number;
}

/** A drag under way: a function of where the pointer is, counted from the start alone. */
export interface Drag {
  /**
   * The pose for a place of the pointer: a new array, and at the place of the start the very values
   * of the start.
   *
   * @param present the pose shown now: of equivalent angles the nearest to these are taken, so that
   *   sliders turn on past ±π; the start's where absent
   */
  move(pointer: DragPointer, present?: Float64Array): Float64Array;
  /** Where the grabbed point is in a pose, character space: where a drag in another mode goes on. */
  grabbedAt(q: Float64Array): [number, number, number];
}

export function beginDrag(drag: DragStart): Drag {
  const { skeleton, joint, pointer, mode } = drag;
  const q = drag.q.slice();
  const start = turnStart(skeleton, joint, q);
  const grabbed = Float64Array.from(drag.grabbed);
  const held = inFrame(start.frames.characterFromJoint, grabbed);
  // What was grabbed beside the ray stays beside it, so that the first move does not jump.
  const beside = vec3.subtract(new Float64Array(3), grabbed, closestOnRay(pointer.ray, grabbed));
  const moveTo = moveIn(mode);

  return {
    move(to, present = q) {
      if (isSame(to, pointer)) return q.slice();
      const { direction } = to.ray;
      const origin = vec3.add(new Float64Array(3), to.ray.origin, beside);
      const motion = [to.x - pointer.x, to.y - pointer.y] as const;
      return moveTo({ origin, direction }, motion, present);
    },
    grabbedAt(values) {
      const { characterFromJoint } = jointFrames(
        skeleton,
        joint,
        values,
        parentMatrix(skeleton, joint, values),
      );
      const place = vec3.transformMat4(new Float64Array(3), held, characterFromJoint);
      return [place[0], place[1], place[2]];
    },
  };

  function moveIn(chosen: DragMode): Move {
    const leastReach = drag.leastReach ?? 0;
    switch (chosen.kind) {
      case 'follow': {
        if (vec3.distance(grabbed, start.pivot) <= leastReach)
          return turnWithMotion(start, drag.view);
        const follow = followRay(start, grabbed, held, pointer.ray);
        return (ray, _, present) => follow(ray, present);
      }
      case 'value':
        return setValue(start, grabbed, chosen.index, drag.view, leastReach);
      case 'course':
        return turnWithMotion(start, drag.view);
      case 'roll': {
        const axis = rollAxis(start, chosen.farEnd);
        if (!axis) return () => q.slice();
        return (_, motion, present) =>
          rollFrom(
            start,
            chosen.farEnd,
            knobAngle(axis, drag.view, motion, knobPixelRate),
            present,
          );
      }
    }
  }
}

type Move = (ray: Ray, motion: readonly [number, number], present: Float64Array) => Float64Array;

/** CS354's program: points that face the eye go with the mouse, however far away they are. */
function turnWithMotion(start: TurnStart, { right, up, look }: ViewAxes): Move {
  return (_, [x, y], present) => {
    const motion = vec3.scale(new Float64Array(3), right, x);
    vec3.scaleAndAdd(motion, motion, up, y);
    const axis = vec3.cross(new Float64Array(3), motion, look);
    vec3.normalize(axis, axis);
    return turnJoint(start, turnAbout(axis, coursePixelRate * Math.hypot(x, y)), present);
  };
}

function setValue(
  { skeleton, q, frames }: TurnStart,
  grabbed: vec3,
  index: number,
  view: ViewAxes,
  leastReach: number,
): Move {
  const dof = frames.dofs.find((each) => each.index === index);
  assert(dof !== undefined, 'a value of the joint that is dragged');
  const [value, min, max] = [q[index]!, skeleton.qMin[index]!, skeleton.qMax[index]!];
  const single = { dof, value, min, max };
  const isKnob = isHinge(dof) && radiusAbout(dof, grabbed) <= leastReach;
  return (ray, motion, present) => {
    const next = q.slice();
    const wanted = isKnob
      ? value + knobAngle(dof.axis, view, motion, knobPixelRate)
      : nearestValue(single, grabbed, ray, present[index]!);
    next[index] = Math.min(Math.max(wanted, min), max);
    return next;
  };
}

function isHinge({ kind }: DofFrame): boolean {
  return kind === DofKind.hinge;
}

function isSame(a: DragPointer, b: DragPointer): boolean {
  return (
    a.x === b.x &&
    a.y === b.y &&
    vec3.exactEquals(a.ray.origin, b.ray.origin) &&
    vec3.exactEquals(a.ray.direction, b.ray.direction)
  );
}

function closestOnRay(ray: Ray, point: vec3): vec3 {
  const offset = vec3.subtract(new Float64Array(3), point, ray.origin);
  return pointOnRay(ray, vec3.dot(offset, ray.direction));
}

function inFrame(worldFromFrame: mat4, point: vec3): vec3 {
  const frameFromWorld: mat4 = new Float64Array(16);
  assert(mat4.invert(frameFromWorld, worldFromFrame) !== null, 'a frame that has an inverse');
  return vec3.transformMat4(new Float64Array(3), point, frameFromWorld);
}
