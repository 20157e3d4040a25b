import type { Camera } from '../document/camera.ts';

export type AxisViewId = 'front' | 'back' | 'right' | 'left' | 'top' | 'bottom';

/** A direction of view along an axis of the scene; angles in radians. */
export interface AxisView extends Pick<Camera, 'azimuth' | 'elevation'> {
  readonly id: AxisViewId;
  readonly label: string;
}

const quarter = Math.PI / 2;

/**
 * The views along the axes. Characters look along +z, into the front view; right and left are those
 * of the front view, as in Blender. From above and below, +x is on the right.
 */
export const axisViews: readonly AxisView[] = [
  { id: 'front', label: 'Front', azimuth: 0, elevation: 0 },
  { id: 'back', label: 'Back', azimuth: Math.PI, elevation: 0 },
  { id: 'right', label: 'Right', azimuth: quarter, elevation: 0 },
  { id: 'left', label: 'Left', azimuth: -quarter, elevation: 0 },
  { id: 'top', label: 'Top', azimuth: 0, elevation: quarter },
  { id: 'bottom', label: 'Bottom', azimuth: 0, elevation: -quarter },
];

/** Looks at the same target along an axis, without perspective. */
export function alongAxis(camera: Camera, id: AxisViewId): Camera {
  const { azimuth, elevation } = axisViews.find((view) => view.id === id)!;
  return { ...camera, azimuth, elevation, projection: 'orthographic' };
}

/** The axis view that a camera has exactly, if any. */
export function axisViewOf({ azimuth, elevation }: Camera): AxisView | undefined {
  return axisViews.find(
    (view) => view.elevation === elevation && Math.abs(turnBetween(view.azimuth, azimuth)) < 1e-9,
  );
}

/** The angle between two azimuths, within half a turn. */
export function turnBetween(from: number, to: number): number {
  return Math.atan2(Math.sin(to - from), Math.cos(to - from));
}
