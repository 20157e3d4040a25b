import { vec3 } from 'gl-matrix';
import type { Camera } from '../document/camera.ts';
import { axesOf, eyeOf } from './camera.ts';
import { highest } from './camera-moves.ts';

/**
 * A camera that stands at its eye and looks around, with perspective, in scene space and radians. It
 * is drawn as the orbit camera with the same view (`orbitFrom`), so nothing else needs to know about
 * it.
 */
export interface FirstPerson {
  readonly eye: readonly [number, number, number];
  /** The angle around +y, counterclockwise from above; at 0 the camera looks along -z. */
  readonly yaw: number;
  /** The angle above the horizon. */
  readonly pitch: number;
  readonly fieldOfView: number;
  /** The distance to the orbit camera's target ahead, which is that of the camera it came from. */
  readonly distance: number;
}

/**
 * Returns the first-person camera with the orbit camera's eye and view. An orthographic camera stands
 * where one with perspective sees its target in the same size.
 */
export function firstPersonFrom(camera: Camera): FirstPerson {
  const [x, y, z] = eyeOf({ ...camera, projection: 'perspective' }) as [number, number, number];
  const { azimuth, elevation, fieldOfView, distance } = camera;
  return { eye: [x, y, z], yaw: azimuth, pitch: -elevation, fieldOfView, distance };
}

/** Returns the orbit camera with the same view, its target ahead at the former distance. */
export function orbitFrom({ eye, yaw, pitch, fieldOfView, distance }: FirstPerson): Camera {
  const camera: Camera = {
    ...{ target: eye, distance, azimuth: yaw, elevation: -pitch, fieldOfView },
    projection: 'perspective',
  };
  const { look } = axesOf(camera);
  return {
    ...camera,
    target: [eye[0] + distance * look[0], eye[1] + distance * look[1], eye[2] + distance * look[2]],
  };
}

/** Moves the eye ahead along the line of sight, sideways, and straight up, in scene units. */
export function walk(view: FirstPerson, ahead: number, right: number, up: number): FirstPerson {
  const axes = axesOf(orbitFrom(view));
  const eye = vec3.scaleAndAdd(new Float64Array(3), view.eye, axes.look, ahead);
  vec3.scaleAndAdd(eye, eye, axes.right, right);
  return { ...view, eye: [eye[0], eye[1] + up, eye[2]] };
}

/** Turns the head to the left and up, but never past the pole. */
export function lookAround(view: FirstPerson, left: number, up: number): FirstPerson {
  const pitch = Math.min(highest, Math.max(-highest, view.pitch + up));
  return { ...view, yaw: view.yaw + left, pitch };
}
