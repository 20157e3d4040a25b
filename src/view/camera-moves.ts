import { vec3 } from 'gl-matrix';
import type { Camera } from '../document/camera.ts';
import { axesOf, halfHeightOf } from './camera.ts';

/** The largest angle at which a camera looks up or down; it never turns over. */
export const highest = (89 * Math.PI) / 180;

/** Turns the camera about its target, by angles in radians. */
export function orbit(camera: Camera, azimuthChange: number, elevationChange: number): Camera {
  const elevation = camera.elevation + elevationChange;
  return {
    ...camera,
    azimuth: camera.azimuth + azimuthChange,
    elevation: Math.min(highest, Math.max(-highest, elevation)),
  };
}

/** Moves the target in the picture's plane, right and up, by fractions of the picture's height. */
export function pan(camera: Camera, right: number, up: number): Camera {
  const axes = axesOf(camera);
  const scale = 2 * halfHeightOf(camera);
  const target = vec3.scaleAndAdd(new Float64Array(3), camera.target, axes.right, right * scale);
  vec3.scaleAndAdd(target, target, axes.up, up * scale);
  return { ...camera, target: [target[0], target[1], target[2]] };
}

/** Half the height of the film of a 35 mm camera, in mm. */
const halfFilmHeight = 12;

/** The focal length in mm with which a 35 mm camera (24 mm of film in height) has a field of view. */
export function focalLengthOf(fieldOfView: number): number {
  return halfFilmHeight / Math.tan(fieldOfView / 2);
}

/** The vertical field of view in radians of a 35 mm camera with a focal length in mm. */
export function fieldOfViewOf(focalLength: number): number {
  return 2 * Math.atan(halfFilmHeight / focalLength);
}
