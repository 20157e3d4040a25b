import type { Camera } from '../document/camera.ts';

/** The frame of a picture in the middle of a view, as parts of the view's width and height. */
export interface ShotFrame {
  readonly width: number;
  readonly height: number;
}

/** The room beside a frame, as a part of the view's shorter side. */
const inset = 0.04;

/**
 * Returns the largest frame with a ratio of width to height that leaves some room around it; without
 * a ratio, the whole view.
 *
 * @param aspect of the view
 */
export function frameWithin(aspect: number, ratio: number | null): ShotFrame {
  if (ratio === null) return { width: 1, height: 1 };
  const room = 2 * inset * Math.min(1, aspect);
  const height = Math.min(1 - room, (aspect - room) / ratio);
  return { width: (height * ratio) / aspect, height };
}

/** Returns the camera whose view is `factor` times as high as this one's, about the same middle. */
export function widened(camera: Camera, factor: number): Camera {
  if (factor === 1) return camera;
  const fieldOfView = 2 * Math.atan(factor * Math.tan(camera.fieldOfView / 2));
  return { ...camera, fieldOfView };
}

/** How a picture of a ratio lies in a view. */
export interface Framing {
  /** Width by height. */
  readonly ratio: number;
  /** Returns the camera of the whole view from that of the picture. */
  viewCamera(camera: Camera, aspect: number): Camera;
}

export function framingOf(ratio: number | null): Framing | null {
  if (ratio === null) return null;
  return {
    ratio,
    viewCamera: (camera, aspect) => widened(camera, 1 / frameWithin(aspect, ratio).height),
  };
}
