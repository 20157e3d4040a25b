import type { ViewAxes } from '../posing/mouse-turns.ts';
import type { Camera } from './camera.ts';

/** The largest angle at which a camera looks up or down; it never turns over. */
export const highest = (89 * Math.PI) / 180;

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
  const { azimuth, elevation, distance, fieldOfView } = camera;
  const scale = 2 * distance * Math.tan(fieldOfView / 2);
  const [sin, cos] = [Math.sin(azimuth), Math.cos(azimuth)];
  const rise = Math.cos(elevation) * up * scale;
  const back = Math.sin(elevation) * up * scale;
  const side = right * scale;
  const [x, y, z] = camera.target;
  return {
    ...camera,
    target: [x + cos * side - sin * back, y + rise, z - sin * side - cos * back],
  };
}
