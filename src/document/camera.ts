/**
 * How a picture is projected. In an orthographic one all lines of sight are parallel, so that size
 * does not change with distance.
 */
export type Projection = 'perspective' | 'orthographic';

/**
 * An orbit camera in scene space, which looks at `target` from `distance` away. Angles are in
 * radians.
 */
export interface Camera {
  readonly target: readonly [number, number, number];
  readonly distance: number;
  /**
   * The angle around +y. At 0 the camera looks from +z; positive values are on the character's left
   * (+x).
   */
  readonly azimuth: number;
  /** The angle above the horizon. */
  readonly elevation: number;
  /** The vertical field of view. */
  readonly fieldOfView: number;
  /** In either projection, what is as far away as the target has the same size. */
  readonly projection: Projection;
}

/** The camera of an empty scene, until a workspace or a character sets another one. */
export const startCamera: Camera = {
  target: [0, 0.5, 0],
  distance: 2.5,
  azimuth: 0,
  elevation: 0,
  fieldOfView: 0.5,
  projection: 'perspective',
};
