import { mat4, vec3 } from 'gl-matrix';
import { type Bounds, isEmpty } from '../core/bounds.ts';
import type { Camera } from '../document/camera.ts';
import type { ViewAxes } from '../posing/mouse-turns.ts';

export { startCamera } from '../document/camera.ts';

/** The limits of a camera's distance, in scene units; characters in their file's units are large. */
const [nearest, farthest] = [0.02, 1000];
/** What is farther behind the target is cut off, in scene units, or farther than the camera. */
const leastDepthBehind = 60;
/**
 * The distance of an orthographic camera's eye, in scene units: from there, lines of sight are
 * parallel, while rays and directions to the eye need no case of their own.
 */
const farAway = 1e5;

/** Returns unit vectors of the scene that point to the picture's right, to its top and into it. */
export function axesOf({ azimuth, elevation }: Camera): ViewAxes {
  const [sin, cos] = [Math.sin(azimuth), Math.cos(azimuth)];
  const [rise, level] = [Math.sin(elevation), Math.cos(elevation)];
  return {
    right: [cos, 0, -sin],
    up: [-sin * rise, level, -cos * rise],
    look: [-sin * level, -rise, -cos * level],
  };
}

/** The distance from the eye to the target. */
export function reachOf({ projection, distance }: Camera): number {
  return projection === 'perspective' ? distance : farAway;
}

export function eyeOf(camera: Camera): vec3 {
  const { look } = axesOf(camera);
  return vec3.scaleAndAdd(new Float64Array(3), camera.target, look, -reachOf(camera));
}

/** The distance before the camera at which things are cut off. */
export function nearOf({ projection, distance }: Camera): number {
  // A camera without perspective also shows what is beside and behind the place it orbits at.
  return projection === 'perspective' ? distance * 0.02 : farAway - depthBehind(distance);
}

function depthBehind(distance: number): number {
  return Math.max(leastDepthBehind, distance);
}

/** Half the height of what the picture shows of the plane through the target, in scene units. */
export function halfHeightOf({ distance, fieldOfView }: Camera): number {
  return distance * Math.tan(fieldOfView / 2);
}

/** Transforms scene space to clip space, in float64. */
export function clipFromScene(camera: Camera, aspect: number): mat4 {
  const view = viewFromScene(axesOf(camera), eyeOf(camera));
  const clip: mat4 = new Float64Array(16);
  const [near, far] = [nearOf(camera), reachOf(camera) + depthBehind(camera.distance)];
  if (camera.projection === 'perspective') {
    mat4.perspective(clip, camera.fieldOfView, aspect, near, far);
  } else {
    const height = halfHeightOf(camera);
    mat4.ortho(clip, -height * aspect, height * aspect, -height, height, near, far);
  }
  return mat4.multiply(clip, clip, view);
}

/** Transforms scene space to the space of an eye that looks along its -z, with x to its right. */
export function viewFromScene({ right, up, look }: ViewAxes, eye: vec3): mat4 {
  return Float64Array.of(
    ...[right[0], up[0], -look[0], 0],
    ...[right[1], up[1], -look[1], 0],
    ...[right[2], up[2], -look[2], 0],
    ...[-vec3.dot(right, eye), -vec3.dot(up, eye), vec3.dot(look, eye), 1],
  );
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
  const target = vec3.lerp(new Float64Array(3), box.min, box.max, 0.5);
  const { right, up, look } = axesOf(camera);
  const height = Math.tan(camera.fieldOfView / 2) / margin;
  // With perspective, what is nearer than the target is larger.
  const growth = camera.projection === 'perspective' ? -1 : 0;
  let distance = 0;
  for (let corner = 0; corner < 8; corner++) {
    const at: vec3 = [0, 1, 2].map((i) => (corner & (1 << i) ? box.max : box.min)[i]! - target[i]!);
    const nearer = growth * vec3.dot(at, look);
    distance = Math.max(
      distance,
      Math.abs(vec3.dot(at, right)) / (height * aspect) + nearer,
      Math.abs(vec3.dot(at, up)) / height + nearer,
    );
  }
  return zoom({ ...camera, target: [target[0], target[1], target[2]], distance }, 1);
}
