import { mat4, vec3 } from 'gl-matrix';
import { bonesOf } from '../core/bones.ts';
import type { ActiveDof, HandleId } from '../document/session.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import { noParent } from '../core/skeleton.ts';
import { type JointRing, jointRings } from '../posing/joint-rings.ts';
import type { RingPlace } from '../posing/ring-turn.ts';
import { type Overlay, type OverlayLine, type OverlayView, pixelSizeAt } from './overlay.ts';
import { palette } from './theme.ts';
import type { SessionOptions } from './view-options.ts';

/** How the rings at the selected joint look. */
export interface Gizmo {
  readonly joint: number;
  /** In CSS pixels. */
  readonly radius: number;
  readonly hovered: HandleId | null;
  /** The ring of the active degree of freedom. */
  readonly active: HandleId | null;
}

/** A ring of the selected joint as it is placed in the scene. */
export interface GizmoRing extends RingPlace {
  readonly id: HandleId;
  readonly ring: JointRing;
}

/** In CSS pixels: for a mouse, and for fingers. */
const [mouseRadius, touchRadius] = [70, 96];
/** The number of straight pieces of a full circle. */
const pieces = 96;
const fullTurn = 2 * Math.PI;
/** In CSS pixels. */
const [ringWidth, activeWidth, markWidth] = [2.25, 3, 4];
/** The opacity of a ring beyond its limits. */
const beyondOpacity = 0.35;
/** Where the mark of the present value begins and ends, as parts of the radius. */
const [markStart, markEnd] = [0.86, 1.14];

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
    radius: byTouch ? touchRadius : mouseRadius,
    hovered: options.hoveredHandle,
    active: activeDof && handleOf(activeDof),
  };
}

/** The handle of a degree of freedom of the selected joint. */
function handleOf({ index, ballAxis }: Pick<ActiveDof, 'index' | 'ballAxis'>): HandleId {
  return ballAxis === undefined ? `${index}` : `${index} ${ballAxis}`;
}

/** Returns the rings of the selected joint, each of a constant radius in the picture. */
export function gizmoRings(
  { state: { character }, pose, characterFromJoint, display }: Evaluation,
  view: OverlayView,
  { joint, radius }: Gizmo,
): GizmoRing[] {
  const { skeleton } = character;
  const parent = skeleton.parents[joint]!;
  const characterFromParent =
    parent === noParent
      ? mat4.identity(new Float64Array(16))
      : characterFromJoint.subarray(parent * 16, parent * 16 + 16);
  const limb = bonesOf(character).find((bone) => bone.joint === joint)?.vector ?? null;
  const { sceneFromCharacter, scale } = display;
  const inScene = (vector: vec3, length: number): vec3 => {
    const origin = mat4.getTranslation(new Float64Array(3), sceneFromCharacter);
    const tip = vec3.transformMat4(new Float64Array(3), vector, sceneFromCharacter);
    return vec3.scale(tip, vec3.subtract(tip, tip, origin), length / scale);
  };
  return jointRings(skeleton, joint, pose.q, characterFromParent, limb).flatMap((ring) => {
    const center = vec3.transformMat4(new Float64Array(3), ring.center, sceneFromCharacter);
    const length = radius * pixelSizeAt(view, center);
    if (length <= 0) return [];
    const second = vec3.cross(new Float64Array(3), ring.normal, ring.mark);
    const [first, quarter] = [inScene(ring.mark, length), inScene(second, length)];
    return [{ id: handleOf(ring), ring, center, first, second: quarter }];
  });
}

/**
 * Returns the lines of rings in the colors of their axes: strong where the value may go, faint
 * beyond its limits, with a mark at the present value. The active ring is amber, and the hovered one
 * lighter; both are drawn over the others.
 */
export function gizmoLines(rings: readonly GizmoRing[], { hovered, active }: Gizmo): Overlay {
  const rank = ({ id }: GizmoRing): number => (id === active ? 2 : id === hovered ? 1 : 0);
  const sorted = [...rings].sort((a, b) => rank(a) - rank(b));
  return sorted.flatMap((each) => {
    const { id, ring } = each;
    const isMarked = id === active || id === hovered;
    const plain = id === active ? palette.selected : palette.axes[ring.axis];
    const color = id === hovered && id !== active ? lighter(plain) : plain;
    const width = isMarked ? activeWidth : ringWidth;
    const line = (points: vec3[], opacity = 1, lineWidth = width): OverlayLine => {
      return { id, points, color, opacity, width: lineWidth };
    };
    const [least, most] = ring.range;
    // A ball has no value and no limits of its own.
    if (ring.ballAxis !== undefined) return [line(arc(each, 0, fullTurn))];
    const mark = line([pointOf(each, 0, markStart), pointOf(each, 0, markEnd)], 1, markWidth);
    if (most - least >= fullTurn) return [line(arc(each, 0, fullTurn)), mark];
    const beyond = line(arc(each, most, least + fullTurn), beyondOpacity);
    return [beyond, line(arc(each, least, most)), mark];
  });
}

/** Points of a ring from one angle to another, closely enough to look round. */
export function arc(ring: RingPlace, from: number, to: number): vec3[] {
  const count = Math.max(1, Math.ceil(((to - from) / fullTurn) * pieces));
  return Array.from({ length: count + 1 }, (_, i) =>
    pointOf(ring, from + ((to - from) * i) / count),
  );
}

function pointOf({ center, first, second }: RingPlace, angle: number, part = 1): vec3 {
  const point = vec3.scaleAndAdd(new Float64Array(3), center, first, part * Math.cos(angle));
  return vec3.scaleAndAdd(point, point, second, part * Math.sin(angle));
}

/** The color of what the pointer is over. */
export function lighter(color: readonly number[]): number[] {
  return color.map((channel) => channel + (1 - channel) * 0.45);
}
