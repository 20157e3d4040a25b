import { vec3 } from 'gl-matrix';
import { angleBetween } from './angle-between.ts';
import type { Body } from './body.ts';

/** A finger that stands bent farther, in radians, tells its axis itself. */
const clearBend = Math.PI / 6;

/**
 * The axis about which a finger curls by a positive angle, toward the palm; of any length. A finger
 * that stands bent tells it itself. Else the palm is found by the thumb: on a left hand, it faces
 * along fingers × thumb, on a right hand the other way. Of a hand whose name tells no side, it is
 * the side of the fingers' plane where the thumb is. Without a thumb it is below, as in the rest
 * poses of most files.
 */
export function curlAxis(body: Body, joint: number, along: vec3): vec3 {
  const parent = body.skeleton.parents[joint]!;
  if (parent >= 0 && body.roles[joint] === 'finger') {
    const above = vec3.subtract(new Float64Array(3), body.places[joint]!, body.places[parent]!);
    if (vec3.length(above) > 1e-8 && angleBetween(above, along) > clearBend) {
      return vec3.cross(new Float64Array(3), above, along);
    }
  }
  return vec3.cross(new Float64Array(3), along, palmNormal(body, joint) ?? [0, -1, 0]);
}

function palmNormal(body: Body, joint: number): vec3 | null {
  const { skeleton, roles, sides, places } = body;
  const { parents, depths } = skeleton;
  const isThumb = (at: number): boolean => roles[at] === 'thumb';
  // The hand is the nearest joint above that has a thumb.
  for (let hand = parents[joint]!; hand >= 0; hand = parents[hand]!) {
    const below: number[] = [];
    for (let at = hand + 1; at < roles.length && depths[at]! > depths[hand]!; at++) below.push(at);
    const thumb = below.filter(isThumb);
    const knuckles = below.filter(
      (at) => roles[at] === 'finger' && roles[parents[at]!] !== 'finger',
    );
    if (thumb.length === 0 || knuckles.length === 0) continue;
    const knuckle = meanOf(knuckles.map((at) => places[at]!));
    const toFingers = vec3.subtract(new Float64Array(3), knuckle, places[hand]!);
    const toThumb = vec3.subtract(
      new Float64Array(3),
      meanOf(thumb.map((at) => places[at]!)),
      knuckle,
    );
    const normal = vec3.cross(new Float64Array(3), toFingers, toThumb);
    const side = sides[joint] ?? sides[hand] ?? null;
    if (side === 'left') return normal;
    if (side === 'right') return vec3.scale(normal, normal, -1);
    const flat = flatNormal(
      places[hand]!,
      knuckles.map((at) => places[at]!),
    );
    return vec3.scale(flat, flat, Math.sign(vec3.dot(flat, toThumb)) || 1);
  }
  return null;
}

/** A normal of the plane from the wrist to the first and the last knuckle. */
function flatNormal(wrist: vec3, knuckles: readonly vec3[]): vec3 {
  const first = vec3.subtract(new Float64Array(3), knuckles[0]!, wrist);
  const last = vec3.subtract(new Float64Array(3), knuckles.at(-1)!, wrist);
  return vec3.cross(new Float64Array(3), first, last);
}

function meanOf(places: readonly vec3[]): vec3 {
  const mean = new Float64Array(3);
  for (const place of places) vec3.scaleAndAdd(mean, mean, place, 1 / places.length);
  return mean;
}
