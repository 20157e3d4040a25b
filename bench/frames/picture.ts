/** What every contender draws, so that the frames can be compared. */
export const pictureWidth = 904;
export const pictureHeight = 863;

const degrees = Math.PI / 180;

/** An orbit camera, in the scene's units and radians. */
export const startCamera = {
  target: [0, 0.5, 0] as const,
  distance: 2.4,
  azimuth: 36 * degrees,
  elevation: 9 * degrees,
  fieldOfView: 28 * degrees,
};

/** The azimuth of the camera in a frame of its movement. */
export function azimuthOf(frame: number): number {
  return startCamera.azimuth + 0.3 * Math.sin(0.5 * frame);
}

/** Directions to the lights, in degrees about +y from +z and above the floor; the first one casts. */
export const lights = [
  { color: 0xfff7ec, intensity: 1.45, azimuth: -18, elevation: 48 },
  { color: 0xd9eaff, intensity: 0.22, azimuth: 88, elevation: 16 },
  { color: 0xeef7ff, intensity: 0.5, azimuth: 168, elevation: 34 },
] as const;
