import { vec3 } from 'gl-matrix';
import { pointOnRay, sphereSpan } from '../core/ray.ts';
import type { Light } from '../document/environment.ts';
import type { Pixels } from '../posing/ring-turn.ts';
import { axesOf, reachOf } from './camera.ts';
import { lightDirection } from './light-direction.ts';
import { lightSphereRadius } from './light-handles.ts';
import { type OverlayView, pixelSizeAt } from './overlay.ts';
import { rayThrough } from './picking.ts';

export type LightAngles = Pick<Light, 'azimuth' | 'elevation'>;

/** Whether a light stands on the half of its sphere that the viewer sees from outside. */
export function isInFront(light: LightAngles, { camera }: OverlayView): boolean {
  return vec3.dot(lightDirection(light), axesOf(camera).look) <= 0;
}

/**
 * Returns the direction in which a light stands whose disc is seen at a place of the view. Beyond
 * the sphere's outline it goes on behind, or from behind to the front, as a ball rolls.
 *
 * @param place pixels from the view's middle, y up
 * @param front which half of the sphere counts where the place is within its outline
 */
export function lightAnglesAt(view: OverlayView, place: Pixels, front: boolean): LightAngles {
  const { camera, width, height } = view;
  const radius = lightSphereRadius(view);
  // The outline of a sphere at the middle of the view is a circle.
  const reach = reachOf(camera);
  const outline = radius / Math.sqrt(1 - (radius / reach) ** 2) / pixelSizeAt(view, camera.target);
  const distance = Math.hypot(...place);
  const isBeyond = distance > outline;
  const within = isBeyond ? Math.max(0, 2 * outline - distance) : distance;
  // Just inside the outline, so that rounding makes no ray miss.
  const scale = Math.min(within, outline * (1 - 1e-9)) / distance || 0;
  const ray = rayThrough(
    camera,
    width / height,
    (2 * place[0] * scale) / width,
    (2 * place[1] * scale) / height,
  );
  const [near, far] = sphereSpan(ray, camera.target, radius) ?? [reach, reach];
  const point = pointOnRay(ray, front !== isBeyond ? near : far);
  const [x, y, z] = vec3.subtract(point, point, camera.target) as [number, number, number];
  const degrees = 180 / Math.PI;
  return {
    azimuth: Math.atan2(x, z) * degrees,
    elevation: Math.asin(Math.min(1, Math.max(-1, y / radius))) * degrees,
  };
}
