import { vec3 } from 'gl-matrix';
import type { Camera } from '../document/camera.ts';
import { turnBetween } from './axis-views.ts';

/**
 * A camera on the way from one to another, by the shorter turn. Distances and fields of view change by
 * equal factors in equal parts of the way, as a steady zoom does. The projection is that of the end.
 *
 * @param part from 0 to 1, where it is exactly `to`
 */
export function cameraBetween(from: Camera, to: Camera, part: number): Camera {
  if (part >= 1) return to;
  const target = vec3.lerp(new Float64Array(3), from.target, to.target, part);
  const grown = (a: number, b: number): number => a * (b / a) ** part;
  const height = grown(Math.tan(from.fieldOfView / 2), Math.tan(to.fieldOfView / 2));
  return {
    target: [target[0], target[1], target[2]],
    distance: grown(from.distance, to.distance),
    azimuth: from.azimuth + part * turnBetween(from.azimuth, to.azimuth),
    elevation: from.elevation + part * (to.elevation - from.elevation),
    fieldOfView: 2 * Math.atan(height),
    projection: to.projection,
  };
}
