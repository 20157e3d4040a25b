import { vec3 } from 'gl-matrix';
import type { RingPlace } from '../posing/ring-turn.ts';
import { type Dashes, type Gizmo, type GizmoRing, isOwnRing } from './gizmo.ts';
import type { Overlay, OverlayFace, OverlayLine } from './overlay.ts';
import { palette } from './theme.ts';

/** The number of straight pieces of a full circle. */
const pieces = 96;
const fullTurn = 2 * Math.PI;
/** In CSS pixels. */
const [ringWidth, activeWidth, markWidth, edgeWidth] = [2.25, 3, 4, 1.5];
/** The opacity of a ring beyond its limits, and of the half that is behind its center. */
const [beyondOpacity, farOpacity] = [0.35, 0.4];
/**
 * The opacity of a ring where it would hide what is around the joint, such as a face, and how far
 * from the joint that is in the picture, as a part of the radius. The ring that is used is not
 * faint there.
 */
const [coverOpacity, coverRadius] = [0.55, 0.6];
/** Where the mark of the present value begins and ends, as parts of the radius. */
const [markStart, markEnd] = [0.86, 1.14];
/** The opacity of what a ring can reach, and of that of the hovered or active ring. */
const [sectorOpacity, markedOpacity] = [0.12, 0.3];
/** A face has to be convex. */
const widestFace = fullTurn / 6;
/** The length of a dash, and of the gap after it. */
const dash = fullTurn / 48;

/**
 * Returns the lines of rings in the colors of their axes: strong where the value may go, faint
 * beyond its limits, behind the joint and where it would hide it, with a mark at the present value. The active ring is
 * amber, and the hovered one lighter; both are drawn over the others. Rings that coincide are broken
 * into dashes, so that both are seen.
 */
export function gizmoLines(rings: readonly GizmoRing[], gizmo: Gizmo): Overlay {
  return byRank(rings, gizmo).flatMap((each) => {
    const { ring } = each;
    const paint = paintOf(each, gizmo);
    const line = (points: vec3[], opacity = 1, width = paint.width): OverlayLine[] =>
      partsOf(points, each, isMarked(each, gizmo)).map(({ part, faintness }) => {
        return { ...paint, points: part, width, opacity: opacity * faintness };
      });
    const along = (from: number, to: number, opacity = 1): OverlayLine[] =>
      dashesIn(from, to, each.dashes).flatMap(([start, end]) =>
        line(arc(each, start, end), opacity),
      );
    // What turns a joint as a whole has no value and no limits of its own, and neither has a ball.
    if (!isOwnRing(ring) || ring.ballAxis !== undefined) return along(0, fullTurn);
    const [least, most] = ring.range;
    const mark = line([pointOf(each, 0, markStart), pointOf(each, 0, markEnd)], 1, markWidth);
    if (most - least >= fullTurn) return [...along(0, fullTurn), ...mark];
    const beyond = along(most, least + fullTurn, beyondOpacity);
    return [...beyond, ...along(least, most), ...mark];
  });
}

/**
 * Returns what limits leave to each ring as a sector from its least to its most value; at the
 * hovered or active ring stronger, with its edges and the present value as lines. They are drawn and
 * not picked.
 */
export function gizmoSectors(rings: readonly GizmoRing[], gizmo: Gizmo): Overlay {
  return byRank(rings, gizmo).flatMap((each): Overlay => {
    const { ring } = each;
    if (!isOwnRing(ring) || ring.ballAxis !== undefined) return [];
    const [least, most] = ring.range;
    if (most - least >= fullTurn) return [];
    const paint = paintOf(each, gizmo);
    const isUsed = isMarked(each, gizmo);
    const opacity = isUsed ? markedOpacity : sectorOpacity;
    const count = Math.max(1, Math.ceil((most - least) / widestFace));
    const at = (part: number): number => least + ((most - least) * part) / count;
    const faces = Array.from({ length: count }, (_, i): OverlayFace => {
      const points = [each.center, ...arc(each, at(i), at(i + 1))];
      return { ...paint, points, opacity, isFilled: true };
    });
    const spoke = (angle: number): OverlayLine => {
      const points = [each.center, pointOf(each, angle)];
      return { ...paint, points, width: edgeWidth, opacity: 1 };
    };
    return isUsed ? [...faces, spoke(least), spoke(most), spoke(0)] : faces;
  });
}

/** The active and the hovered ring come last, over the others. */
function byRank(rings: readonly GizmoRing[], { hovered, active }: Gizmo): GizmoRing[] {
  const rank = ({ id }: GizmoRing): number => (id === active ? 2 : id === hovered ? 1 : 0);
  return [...rings].sort((a, b) => rank(a) - rank(b));
}

function isMarked({ id }: GizmoRing, { hovered, active }: Gizmo): boolean {
  return id === active || id === hovered;
}

function paintOf(each: GizmoRing, gizmo: Gizmo) {
  const { id, ring } = each;
  const { hovered, active } = gizmo;
  const own = ring.axis === null ? palette.screenRing : palette.axes[ring.axis];
  const plain = id === active ? palette.selected : own;
  const color = id === hovered && id !== active ? lighter(plain) : plain;
  return { id, color, width: isMarked(each, gizmo) ? activeWidth : ringWidth };
}

/**
 * Cuts a row of points where it goes behind the center of its ring, as the viewer sees it, and where
 * it is in front of what is around the center.
 */
function partsOf(points: readonly vec3[], { center, toEye }: GizmoRing, isMarked: boolean) {
  const parts: { part: vec3[]; faintness: number }[] = [];
  for (let i = 0; i + 1 < points.length; i++) {
    const [from, to] = [points[i]!, points[i + 1]!];
    const away = vec3.lerp(new Float64Array(3), from, to, 0.5);
    vec3.subtract(away, away, center);
    vec3.normalize(away, away);
    const toward = vec3.dot(away, toEye);
    // The ring about the line of sight has no side that is farther.
    const isFar = toward < -0.02;
    const covers = !isMarked && 1 - toward * toward < coverRadius ** 2;
    const faintness = isFar ? farOpacity : covers ? coverOpacity : 1;
    const last = parts.at(-1);
    if (last?.faintness === faintness) last.part.push(to);
    else parts.push({ part: [from, to], faintness });
  }
  return parts;
}

/** The parts of a range of angles that are drawn. */
function dashesIn(
  from: number,
  to: number,
  dashes?: Dashes,
): readonly (readonly [number, number])[] {
  if (!dashes) return [[from, to]];
  const origin = dashes.from + (dashes.isSecond ? dash : 0);
  const found: [number, number][] = [];
  for (let i = Math.floor((from - origin) / (2 * dash)); origin + 2 * i * dash < to; i++) {
    const start = Math.max(from, origin + 2 * i * dash);
    const end = Math.min(to, origin + (2 * i + 1) * dash);
    if (start < end) found.push([start, end]);
  }
  return found;
}

/** Points of a ring from one angle to another, closely enough to look round. */
export function arc(ring: RingPlace, from: number, to: number): vec3[] {
  const count = Math.max(1, Math.ceil(((to - from) / fullTurn) * pieces));
  return Array.from({ length: count + 1 }, (_, i) =>
    pointOf(ring, from + ((to - from) * i) / count),
  );
}

/** The point of a ring at an angle, at a part of its radius from the center. */
export function pointOf({ center, first, second }: RingPlace, angle: number, part = 1): vec3 {
  const point = vec3.scaleAndAdd(new Float64Array(3), center, first, part * Math.cos(angle));
  return vec3.scaleAndAdd(point, point, second, part * Math.sin(angle));
}

/** The color of what the pointer is over. */
export function lighter(color: readonly number[]): number[] {
  return color.map((channel) => channel + (1 - channel) * 0.45);
}
