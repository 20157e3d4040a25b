import { mat4, type ReadonlyMat4 } from 'gl-matrix';

/** The plane n·x + d = 0 as n (of unit length) and d. The side to which n points is the lit one. */
export type Plane = readonly [x: number, y: number, z: number, d: number];

/** A light's place (w = 1), or the direction to a distant light (w = 0). */
export type PlanarLight = readonly [x: number, y: number, z: number, w: number];

/**
 * Returns the projection of points along a light onto a plane, S = (P·L) I − L Pᵀ (Blinn 1988, "Me
 * and my (fake) shadow"). The projected point is homogeneous: its w is positive if the light shines
 * on the point from the lit side, so that the shadow is real.
 */
export function planarShadow(plane: Plane, light: PlanarLight): mat4 {
  const facing = plane.reduce((sum, component, i) => sum + component * light[i]!, 0);
  const matrix: mat4 = new Float64Array(16);
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      matrix[column * 4 + row] = (row === column ? facing : 0) - light[row]! * plane[column]!;
    }
  }
  return matrix;
}

/** Returns the reflection of points in a plane, x − 2 (n·x + d) n. */
export function planarMirror(plane: Plane): mat4 {
  const matrix = mat4.identity(new Float64Array(16));
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 3; row++) matrix[column * 4 + row]! -= 2 * plane[row]! * plane[column]!;
  }
  return matrix;
}

/**
 * Returns a projection with its near plane replaced, so that nothing behind the plane is drawn and
 * everything before it that was in the picture still is (Lengyel 2005, "Oblique view frustum depth
 * projection and clipping"). The eye must be behind the plane. What is drawn where does not change,
 * only its depth.
 *
 * @param clipFromScene a projection, which may be without perspective
 */
export function clippedBehind(clipFromScene: ReadonlyMat4, plane: Plane): mat4 {
  const sceneFromClip = mat4.invert(new Float64Array(16), clipFromScene)!;
  // The plane in clip space tells which corner of the far plane is the farthest from it.
  const [x, y] = [0, 1].map((column) => dot4(plane, sceneFromClip, column * 4, 1)) as [
    number,
    number,
  ];
  const corner = [Math.sign(x), Math.sign(y), 1, 1];
  const farthest = [0, 1, 2, 3].map((row) => dot4(corner, sceneFromClip, row, 4));
  const scale = 2 / plane.reduce((sum, component, i) => sum + component * farthest[i]!, 0);
  const clipped: mat4 = Float64Array.from(clipFromScene);
  for (let column = 0; column < 4; column++) {
    clipped[column * 4 + 2] = scale * plane[column]! - clipFromScene[column * 4 + 3]!;
  }
  return clipped;
}

/** The dot product with four elements of a matrix. */
function dot4(
  vector: readonly number[],
  matrix: ReadonlyMat4,
  first: number,
  step: number,
): number {
  return vector.reduce((sum, component, i) => sum + component * matrix[first + i * step]!, 0);
}
