import { vec3 } from 'gl-matrix';

/**
 * The angle between two vectors of any length, in radians; 0 if one has none. By its tangent it is
 * exact for small angles too, where the cosine tells nothing.
 */
export function angleBetween(a: vec3, b: vec3): number {
  return Math.atan2(vec3.length(vec3.cross(new Float64Array(3), a, b)), vec3.dot(a, b));
}
