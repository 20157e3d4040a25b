import { mat4, type ReadonlyVec3, vec3 } from 'gl-matrix';
import { bonesOf } from '../core/bones.ts';
import type { ActiveDof, HandleId, PlaceAxes } from '../document/session.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import { noParent } from '../core/skeleton.ts';
import { type FreeRing, freeRings } from '../posing/free-rings.ts';
import { gimbalLock } from '../posing/gimbal-lock.ts';
import { type JointRing, jointRings } from '../posing/joint-rings.ts';
import type { RingPlace } from '../posing/ring-turn.ts';
import { turnStart } from '../posing/turn-joint.ts';
import { axesOf, eyeOf } from './camera.ts';
import { type OverlayView, pixelSizeAt } from './overlay.ts';
import type { SessionOptions } from './view-options.ts';

/** How the rings at the selected joint look. */
export interface Gizmo {
  readonly joint: number;
  /** The axes of the rings, where the joint can turn about any. */
  readonly axes: PlaceAxes;
  /** In CSS pixels. */
  readonly radius: number;
  readonly hovered: HandleId | null;
  /** The ring of the active degree of freedom. */
  readonly active: HandleId | null;
}

/** A ring of the selected joint as it is placed in the scene. */
export interface GizmoRing extends RingPlace {
  readonly id: HandleId;
  readonly ring: JointRing | FreeRing;
  /** Unit vector from the center to the viewer. */
  readonly toEye: vec3;
  /** Where it is broken into dashes because it coincides with another one; see `Dashes`. */
  readonly dashes?: Dashes;
}

/** Which half of a ring is drawn, in turn with the ring that it coincides with. */
export interface Dashes {
  /** The angle from `first` at which the first dash begins. */
  readonly from: number;
  /** Whether a gap comes first. */
  readonly isSecond: boolean;
}

/** In CSS pixels: for a mouse, and for fingers. */
const [mouseRadius, touchRadius] = [70, 96];
/** The radius of the ring about the line of sight, as a part of the others'. */
const outerPart = 1.28;

/**
 * Rings are shown where the selected joint can be posed by them, and not while it moves by itself or
 * the IK lab draws there.
 */
export function gizmoOf(options: SessionOptions): Gizmo | null {
  const { showOverlay, posesBy, playing, selectedJoint, byTouch, activeDof } = options;
  if (!showOverlay || posesBy === 'mode' || playing || selectedJoint === null) return null;
  if (options.ikSketch) return null;
  return {
    joint: selectedJoint,
    axes: options.ringAxes,
    radius: byTouch ? touchRadius : mouseRadius,
    hovered: options.hoveredHandle,
    active: activeDof && handleOf(activeDof),
  };
}

/** The handle of a degree of freedom of the selected joint. */
function handleOf({ index, ballAxis }: Pick<ActiveDof, 'index' | 'ballAxis'>): HandleId {
  return ballAxis === undefined ? `${index}` : `${index} ${ballAxis}`;
}

/** Whether a ring is about an axis of the joint's own, and not about another one. */
export function isOwnRing(ring: JointRing | FreeRing): ring is JointRing {
  return 'index' in ring;
}

/**
 * Returns the rings of the selected joint, each of a constant radius in the picture. A joint that
 * can take any rotation has one about the line of sight, and three about the scene's axes if these
 * are chosen; every other ring is about an axis of its own.
 */
export function gizmoRings(
  { state: { character }, pose, characterFromJoint, display }: Evaluation,
  view: OverlayView,
  { joint, axes, radius }: Gizmo,
): readonly GizmoRing[] {
  const { skeleton } = character;
  const parent = skeleton.parents[joint]!;
  const characterFromParent =
    parent === noParent
      ? mat4.identity(new Float64Array(16))
      : characterFromJoint.slice(parent * 16, parent * 16 + 16);
  const { sceneFromCharacter, scale } = display;
  const start = turnStart(skeleton, joint, pose.q, characterFromParent);
  const { look } = axesOf(view.camera);
  const toViewer: ReadonlyVec3 = [-look[0], -look[1], -look[2]];
  const inCharacter = (axis: 0 | 1 | 2 | null, normal: ReadonlyVec3) => {
    return { axis, normal: inverselyRotated(sceneFromCharacter, normal) };
  };
  const scene = coordinates.map((axis) => inCharacter(axis, unitVectors[axis]));
  const outer = freeRings(start, [inCharacter(null, toViewer)]);
  const inner = axes === 'world' ? freeRings(start, scene) : [];
  const limb = bonesOf(character).find((bone) => bone.joint === joint)?.vector ?? null;
  const own = jointRings(skeleton, joint, pose.q, characterFromParent, limb);
  const rings = [...outer, ...(inner.length > 0 ? inner : own)];

  const inScene = (vector: ReadonlyVec3, length: number): vec3 => {
    const origin = sceneFromCharacter.slice(12, 15);
    const tip = vec3.transformMat4(new Float64Array(3), vector, sceneFromCharacter);
    return vec3.scale(tip, vec3.subtract(tip, tip, origin), length / scale);
  };
  const placed = rings.flatMap((ring): GizmoRing[] => {
    const center = vec3.transformMat4(new Float64Array(3), ring.center, sceneFromCharacter);
    const part = !isOwnRing(ring) && ring.axis === null ? outerPart : 1;
    const length = radius * part * pixelSizeAt(view, center);
    if (length <= 0) return [];
    const second = vec3.cross(new Float64Array(3), ring.normal, ring.mark);
    const [first, quarter] = [inScene(ring.mark, length), inScene(second, length)];
    const toEye = vec3.subtract(new Float64Array(3), eyeOf(view.camera), center);
    vec3.normalize(toEye, toEye);
    return [{ id: idOf(ring), ring, center, first, second: quarter, toEye }];
  });
  return dashed(placed, gimbalLock(skeleton, joint, pose.q));
}

const coordinates = [0, 1, 2] as const;
const unitVectors = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const;

function idOf(ring: JointRing | FreeRing): HandleId {
  if (isOwnRing(ring)) return handleOf(ring);
  return ring.axis === null ? 'joint view' : `joint world ${ring.axis}`;
}

/** Breaks the two rings that turn about one axis into dashes, each where the other has its gaps. */
function dashed(
  rings: readonly GizmoRing[],
  lock: readonly [number, number] | null,
): readonly GizmoRing[] {
  const [outer, inner] = (lock ?? []).map((index) =>
    rings.find(({ ring }) => isOwnRing(ring) && ring.index === index),
  );
  if (!outer || !inner) return rings;
  const from = Math.atan2(vec3.dot(outer.first, inner.second), vec3.dot(outer.first, inner.first));
  const isSecond = vec3.dot(outer.ring.normal, inner.ring.normal) > 0;
  return rings.map((each) => {
    if (each === outer) return { ...each, dashes: { from: 0, isSecond: false } };
    return each === inner ? { ...each, dashes: { from, isSecond } } : each;
  });
}

/** A unit vector of the scene in the character's space; the matrix scales uniformly. */
function inverselyRotated(sceneFromCharacter: Float64Array, vector: ReadonlyVec3): vec3 {
  const rotated = new Float64Array(3);
  for (let i = 0; i < 3; i++) {
    const [x, y, z] = sceneFromCharacter.subarray(i * 4, i * 4 + 3);
    rotated[i] = vec3.dot([x!, y!, z!], vector);
  }
  return vec3.normalize(rotated, rotated);
}
