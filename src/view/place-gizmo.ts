import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { Actor } from '../document/scene.ts';
import type { HandleId, PlaceAxes, PlaceTool } from '../document/session.ts';
import type { RingPlace } from '../posing/ring-turn.ts';
import { axesOf, eyeOf } from './camera.ts';
import { arc, lighter } from './ring-lines.ts';
import {
  type Overlay,
  type OverlayFace,
  type OverlayLine,
  type OverlayView,
  pixelSizeAt,
} from './overlay.ts';
import { palette } from './theme.ts';
import type { SessionOptions } from './view-options.ts';

/** How handles look. */
export interface HandleLook {
  /** In CSS pixels. */
  readonly radius: number;
  readonly hovered: HandleId | null;
  /** Where the lines of arrows begin, as a part of the radius; near the center, if absent. */
  readonly lineStart?: number;
}

/** How the handles of the whole selected character look. */
export interface PlaceGizmo extends HandleLook {
  readonly tool: PlaceTool;
  readonly axes: PlaceAxes;
}

/** A handle by which a whole character is moved, turned or scaled. */
export interface PlaceHandle extends RingPlace {
  readonly id: HandleId;
  /** A line or a plane to move on, a ring to turn, or the ring that scales. */
  readonly kind: 'line' | 'plane' | 'ring' | 'size';
  /** The axis that gives it name and color; null for the plane that faces the viewer, and the size. */
  readonly axis: 0 | 1 | 2 | null;
  /** Unit vector of the scene: along the line, or across the plane or ring. */
  readonly direction: ReadonlyVec3;
}

/** The handle for the floor, by which also the character itself is dragged. */
export const floorHandle: HandleId = 'place plane 1';
/** The handle for the plane that faces the viewer. */
export const viewHandle: HandleId = 'place view';

/** In CSS pixels: for a mouse, and for fingers. */
const [mouseRadius, touchRadius] = [84, 112];
/** In CSS pixels. */
const [lineWidth, hoveredWidth, headWidth] = [2.5, 3.5, 14];
/** Where an arrow's line begins, and its head begins and ends, as parts of the radius. */
const [innerStart, headStart, headEnd] = [0.2, 0.82, 1.08];
/** Where the square of the floor begins and ends, as parts of the radius. */
const [squareStart, squareEnd] = [0.28, 0.52];
/** The radius of the ring about the center, as a part of the whole. */
const centerPart = 0.14;
/** Half the side of the knob on the ring that scales, as a part of the radius. */
const knobPart = 0.07;
const faceOpacity = 0.4;
/** An arrow that points at the viewer, by more than this cosine, can't be dragged. */
const atViewer = 0.98;
/** Nor can a plane that is seen edge-on: the sine of the angle at which the viewer sees it. */
const edgeOn = 0.1;
const fullTurn = 2 * Math.PI;
const coordinates = [0, 1, 2] as const;

/** The handles are shown while a tool for whole characters is chosen and no joint is selected. */
export function placeGizmoOf(options: SessionOptions): PlaceGizmo | null {
  const { showOverlay, placeTool, placeAxes, selectedJoint, byTouch } = options;
  if (!showOverlay || placeTool === null || selectedJoint !== null) return null;
  return {
    tool: placeTool,
    axes: placeAxes,
    radius: byTouch ? touchRadius : mouseRadius,
    hovered: options.hoveredHandle,
  };
}

/** Returns the handles of an actor, of a constant size in the picture, at its transform's origin. */
export function placeHandles(
  { transform }: Pick<Actor, 'transform'>,
  view: OverlayView,
  { tool, axes, radius }: PlaceGizmo,
): PlaceHandle[] {
  const center: ReadonlyVec3 = [...transform.position];
  const length = radius * pixelSizeAt(view, center);
  if (length <= 0) return [];
  const toEye = vec3.subtract(new Float64Array(3), eyeOf(view.camera), center);
  vec3.normalize(toEye, toEye);
  const directions = coordinates.map((axis) => axisOf(transform, axes, axis));
  const scaled = (vector: ReadonlyVec3): vec3 => vec3.scale(new Float64Array(3), vector, length);
  const about = (axis: 0 | 1 | 2) => ({
    center,
    axis,
    direction: directions[axis]!,
    first: scaled(directions[(axis + 1) % 3]!),
    second: scaled(directions[(axis + 2) % 3]!),
  });
  const { right, up } = axesOf(view.camera);
  const facing = { center, axis: null, first: scaled(right), second: scaled(up) };
  if (tool === 'turn') {
    return coordinates.map((axis) => ({
      ...{ id: `place ring ${axis}`, kind: 'ring' },
      ...about(axis),
    }));
  }
  if (tool === 'scale') return [{ id: 'place size', kind: 'size', direction: toEye, ...facing }];
  const axesOfHandles = { lines: coordinates, planes: [1] } as const;
  return slideHandles('place', { center, directions, radius, ...axesOfHandles }, view);
}

/** Where handles move a point, in scene space. */
export interface SlidePlace {
  readonly center: ReadonlyVec3;
  /** Three unit vectors at right angles. */
  readonly directions: readonly ReadonlyVec3[];
  /** In CSS pixels. */
  readonly radius: number;
  /** The axes that have arrows, and those that have squares across them. */
  readonly lines: readonly (0 | 1 | 2)[];
  readonly planes: readonly (0 | 1 | 2)[];
}

/**
 * Returns the handles that move a point: arrows, squares, and the ring for the plane that faces the
 * viewer. Arrows and squares that can't be dragged as they are seen are left out.
 *
 * @param prefix the beginning of their ids
 */
export function slideHandles(
  prefix: string,
  { center, directions, radius, lines, planes }: SlidePlace,
  view: OverlayView,
): PlaceHandle[] {
  const length = radius * pixelSizeAt(view, center);
  if (length <= 0) return [];
  const toEye = vec3.subtract(new Float64Array(3), eyeOf(view.camera), center);
  vec3.normalize(toEye, toEye);
  const sineTo = (axis: 0 | 1 | 2): number => Math.abs(vec3.dot(directions[axis]!, toEye));
  const scaled = (vector: ReadonlyVec3): vec3 => vec3.scale(new Float64Array(3), vector, length);
  const about = (kind: 'line' | 'plane', axis: 0 | 1 | 2): PlaceHandle => ({
    ...{ id: `${prefix} ${kind} ${axis}`, kind, axis, center },
    direction: directions[axis]!,
    first: scaled(directions[(axis + 1) % 3]!),
    second: scaled(directions[(axis + 2) % 3]!),
  });
  const { right, up } = axesOf(view.camera);
  return [
    ...lines.filter((axis) => sineTo(axis) < atViewer).map((axis) => about('line', axis)),
    ...planes.filter((axis) => sineTo(axis) > edgeOn).map((axis) => about('plane', axis)),
    {
      ...{ id: `${prefix} view`, kind: 'plane', axis: null, center, direction: toEye },
      ...{ first: scaled(right), second: scaled(up) },
    },
  ];
}

/** The unit vector of an axis, in the scene: the scene's own, or the character's. */
export function axisOf(
  { rotation }: Actor['transform'],
  axes: PlaceAxes,
  axis: 0 | 1 | 2,
): ReadonlyVec3 {
  const unit = coordinates.map((i) => (i === axis ? 1 : 0)) as [number, number, number];
  if (axes === 'world') return unit;
  return vec3.transformQuat(new Float64Array(3), unit, [...rotation]);
}

/** Returns what is drawn of handles, and picked: in the colors of their axes, the hovered lighter. */
export function placeShapes(handles: readonly PlaceHandle[], look: HandleLook): Overlay {
  const { hovered, lineStart = innerStart } = look;
  const sorted = [...handles].sort((a, b) => Number(a.id === hovered) - Number(b.id === hovered));
  return sorted.flatMap((handle) => shapesOf(handle, handle.id === hovered, lineStart));
}

function shapesOf(handle: PlaceHandle, isHovered: boolean, lineStart: number): Overlay {
  const { id, kind, axis } = handle;
  const plain = axis === null ? palette.selected : palette.axes[axis];
  const color = isHovered ? lighter(plain) : plain;
  const width = isHovered ? hoveredWidth : lineWidth;
  const line = (points: readonly ReadonlyVec3[], widths = { width }): OverlayLine => {
    return { id, points, color, opacity: 1, ...widths };
  };
  const face = (points: readonly ReadonlyVec3[], opacity: number): OverlayFace => {
    return { id, points, color, opacity, isFilled: true };
  };
  if (kind === 'ring') return [line(arc(handle, 0, fullTurn))];
  if (kind === 'size') {
    const knob = squareAt(handle, Math.SQRT1_2, knobPart);
    return [line(arc(handle, 0, fullTurn)), face(knob, 1)];
  }
  if (kind === 'line') {
    const along = vec3.scale(new Float64Array(3), handle.direction, vec3.length(handle.first));
    const at = (part: number): vec3 =>
      vec3.scaleAndAdd(new Float64Array(3), handle.center, along, part);
    const head = { width: headWidth, endWidth: 0 };
    return [line([at(lineStart), at(headStart)]), line([at(headStart), at(headEnd)], head)];
  }
  if (axis === null) return [line(arc(part(handle, centerPart), 0, fullTurn))];
  const middle = (squareStart + squareEnd) / 2;
  const corners = squareAt(handle, middle, middle - squareStart);
  return [face(corners, faceOpacity), line([...corners, corners[0]!])];
}

/** A square across a handle, whose middle lies on the diagonal between its two vectors. */
function squareAt({ center, first, second }: RingPlace, place: number, half: number): vec3[] {
  return [
    [-1, -1],
    [1, -1],
    [1, 1],
    [-1, 1],
  ].map(([a, b]) => {
    const point = vec3.scaleAndAdd(new Float64Array(3), center, first, place + a! * half);
    return vec3.scaleAndAdd(point, point, second, place + b! * half);
  });
}

/** The same ring, smaller. */
function part({ center, first, second }: RingPlace, size: number): RingPlace {
  const smaller = (vector: ReadonlyVec3): vec3 => vec3.scale(new Float64Array(3), vector, size);
  return { center, first: smaller(first), second: smaller(second) };
}
