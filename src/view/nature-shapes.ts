import type { vec3 } from 'gl-matrix';
import type { NatureArc } from './nature-arcs.ts';
import type { Overlay, OverlayFace, OverlayLine } from './overlay.ts';
import { arc, pointOf } from './ring-lines.ts';
import { linear, palette } from './theme.ts';

/** What is only looked at has no handle to pick. */
const id = 'nature';
const color = linear('#0ea5a0');
/** In CSS pixels. */
const [bendWidth, thinWidth, endWidth] = [2, 1.5, 1.25];
const [rimWidth, bendMarkWidth, thinMarkWidth] = [6, 3, 3.5];
const [sectorOpacity, endOpacity, edgeOpacity] = [0.2, 0.55, 0.8];
/** Where the mark of a present angle begins and ends, as parts of the arc's radius. */
const [bendMark, thinMark] = [
  [0.5, 1.2],
  [0.86, 1.14],
] as const;
/** A face has to be convex. */
const widestFace = Math.PI / 3;
/** An angle outside its range by less than this is in it, in radians. */
const tolerance = 1e-3;

/**
 * Returns the shapes of soft ranges: that of bending as a sector, from its least to its most value,
 * and those of side and twist as thin arcs. Each has a mark at the present angle, which is orange
 * outside the range.
 */
export function natureShapes(arcs: readonly NatureArc[]): Overlay {
  return arcs.flatMap((each): Overlay => {
    const [low, high] = each.range;
    const isBend = each.name === 'bend';
    const isOutside = each.value < low - tolerance || each.value > high + tolerance;
    const line = (points: readonly vec3[], width: number, paint = color): OverlayLine => {
      return { id, points, color: paint, width, opacity: 1 };
    };
    const mark = (isBend ? bendMark : thinMark).map((part) => pointOf(each, each.value, part));
    const width = isBend ? bendWidth : thinWidth;
    const edge = { ...line(arc(each, low, high), width), opacity: edgeOpacity };
    if (!isBend) return [edge, line(mark, thinMarkWidth, isOutside ? palette.litBone : color)];
    const ends = [low, high].map((angle) => {
      const points = [0, 1].map((part) => pointOf(each, angle, part));
      return { ...line(points, endWidth), opacity: endOpacity };
    });
    // The limb may have any color, and its light as well, so that the mark has a rim.
    const marks = [
      line(mark, rimWidth),
      line(mark, bendMarkWidth, isOutside ? palette.litBone : palette.hovered),
    ];
    return [...sector(each), edge, ...ends, ...marks];
  });
}

function sector(each: NatureArc): OverlayFace[] {
  const [low, high] = each.range;
  const count = Math.max(1, Math.ceil((high - low) / widestFace));
  const at = (part: number): number => low + ((high - low) * part) / count;
  return Array.from({ length: count }, (_, i) => {
    const points = [each.center, ...arc(each, at(i), at(i + 1))];
    return { id, points, color, opacity: sectorOpacity, isFilled: true as const };
  });
}
