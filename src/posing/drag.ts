import { mat4, vec3 } from 'gl-matrix';
import { assert } from '../core/assert.ts';
import { pointOnRay, type Ray } from '../core/ray.ts';
import { sameValue } from '../core/same-value.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import { followRay } from './follow-ray.ts';
import { type DofFrame, jointFrames, parentMatrix } from './joint-frames.ts';
import { coursePixelRate, knobAngle, knobPixelRate, type ViewAxes } from './mouse-turns.ts';
import { rollAxis, rollFrom } from './roll-joint.ts';
import { nearestValue, radiusAbout } from './single-value.ts';
import { turnAbout, turnJoint, type TurnStart, turnStart } from './turn-joint.ts';

/** The position of the pointer. */
export interface DragPointer {
  /** The pointer's ray, in the character's space. */
  readonly ray: Ray;
  /** CSS pixels, x to the right and y up, from any origin. */
  readonly x: number;
  readonly y: number;
}

/**
 * What a drag does.
 * - `follow`: the joint rotates so that the grabbed point stays under the pointer.
 * - `value`: only one value of q changes, so that the grabbed point is nearest to the pointer.
 * - `course`: the joint rotates about the axis across view and motion, as in CS354's program.
 * - `roll`: the joint rotates about the line to `farEnd` (in its frame), which stays in place.
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
  /** A point of the joint or of a descendant, in the character's space. */
  readonly grabbed: readonly [number, number, number];
  readonly pointer: DragPointer;
  readonly view: ViewAxes;
  readonly mode: DragMode;
  /**
   * A point that is nearer than this to its center or axis of rotation does not follow, because a
   * pixel would be a large rotation; the motion of the pointer rotates the joint instead. In
   * character units; a length of 8 pixels is a good value.
   */
  readonly leastReach?: number;
}

/** A drag in progress: a function of the pointer's position that depends only on the start. */
export interface Drag {
  /**
   * Returns the pose for a position of the pointer as a new array. At the starting position it has
   * exactly the values of the start.
   *
   * @param present the pose that is shown now. Of equivalent angles the nearest to these are taken,
   *   so that sliders continue beyond ±π. If absent, the start's pose is used.
   */
  move(pointer: DragPointer, present?: Float64Array): Float64Array;
  /**
   * The grabbed point in a pose, in the character's space: where a drag in another mode continues.
   */
  grabbedAt(q: Float64Array): [number, number, number];
}

export function beginDrag(drag: DragStart): Drag {
  const { skeleton, joint, pointer, mode } = drag;
  const q = drag.q.slice();
  const start = turnStart(skeleton, joint, q);
  const grabbed = Float64Array.from(drag.grabbed);
  const held = inFrame(start.frames.characterFromJoint, grabbed);
  // Keeps the offset between the grabbed point and the ray, so that the first move does not jump.
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

/**
 * As in CS354's program, points that face the viewer move with the mouse, however distant they are.
 */
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
  return a.x === b.x && a.y === b.y && sameValue(a.ray, b.ray);
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
