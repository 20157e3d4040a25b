import { mat4, vec3 } from 'gl-matrix';
import { type Bounds, isEmpty } from '../core/bounds.ts';
import type { Camera } from '../document/camera.ts';

export { type Camera, startCamera } from '../document/camera.ts';

/** The limits of a camera's distance, in scene units. */
const [nearest, farthest] = [0.02, 40];

export function eyeOf(camera: Camera): vec3 {
  const { target, distance, azimuth, elevation } = camera;
  const level = distance * Math.cos(elevation);
  return [
    target[0] + level * Math.sin(azimuth),
    target[1] + distance * Math.sin(elevation),
    target[2] + level * Math.cos(azimuth),
  ];
}

/** The distance before the camera at which things are cut off. */
export function nearOf({ distance }: Camera): number {
  return distance * 0.02;
}

/** Transforms scene space to clip space, in float64. */
export function clipFromScene(camera: Camera, aspect: number): mat4 {
  const viewFromScene: mat4 = new Float64Array(16);
  mat4.lookAt(viewFromScene, eyeOf(camera), camera.target, [0, 1, 0]);
  const clipFromView: mat4 = new Float64Array(16);
  const { fieldOfView, distance } = camera;
  mat4.perspective(clipFromView, fieldOfView, aspect, nearOf(camera), distance + 60);
  return mat4.multiply(new Float64Array(16), clipFromView, viewFromScene);
}

/** Moves the camera nearer (factor below 1) or farther. */
export function zoom(camera: Camera, factor: number): Camera {
  const distance = Math.min(farthest, Math.max(nearest, camera.distance * factor));
  return { ...camera, distance };
}

/** The room around what is framed, as a factor of its size. */
const margin = 1.1;

/** Keeps the direction of view and fits a box (in scene space) into the picture, with a margin. */
export function frameBox(camera: Camera, box: Bounds, aspect: number): Camera {
  if (isEmpty(box)) return camera;
  const target = [0, 1, 2].map((axis) => (box.min[axis]! + box.max[axis]!) / 2);
  const framed: Camera = { ...camera, target: target as [number, number, number] };
  const viewFromScene = mat4.lookAt(
    new Float64Array(16),
    eyeOf({ ...framed, distance: 1 }),
    framed.target,
    [0, 1, 0],
  );
  const up = Math.tan(camera.fieldOfView / 2) / margin;
  const right = up * aspect;
  let distance = 0;
  for (let corner = 0; corner < 8; corner++) {
    const at: vec3 = [0, 1, 2].map((i) => (corner & (1 << i) ? box.max : box.min)[i]!);
    const [x, y, z] = vec3.transformMat4(new Float64Array(3), at, viewFromScene);
    // The view looks along -z from a distance of 1, so z + 1 is how far a corner is in front of the
    // target.
    distance = Math.max(distance, Math.abs(x!) / right + z! + 1, Math.abs(y!) / up + z! + 1);
  }
  return zoom({ ...framed, distance }, 1);
}
