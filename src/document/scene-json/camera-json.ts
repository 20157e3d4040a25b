import { defaultLimits } from '../../core/limits.ts';
import { type Camera, startCamera } from '../camera.ts';
import { numbers, numberWithin, oneOf } from './codec.ts';
import { fields } from './fields.ts';

const { coordinate } = defaultLimits;

/** Angles that were turned often are large, but no larger than this. */
const angle = numberWithin(-1e6, 1e6);

export const cameraJson = fields(startCamera, {
  target: numbers<Camera['target']>(3, coordinate),
  distance: numberWithin(1e-6, coordinate),
  azimuth: angle,
  elevation: angle,
  fieldOfView: numberWithin(1e-3, Math.PI - 1e-3),
  projection: oneOf(['perspective', 'orthographic']),
});
