import { defaultLimits } from '../../core/limits.ts';
import { type Transform, unmoved } from '../scene.ts';
import { checked, numbers, numberWithin } from './codec.ts';
import { fields } from './fields.ts';

const { coordinate } = defaultLimits;

/** As near to a unit quaternion as the arithmetic of an edit leaves it. */
const rotation = checked(
  numbers<Transform['rotation']>(4, 1.001),
  (quaternion) => Math.abs(Math.hypot(...quaternion) - 1) < 1e-3,
  'a quaternion of length 1',
);

export const transformJson = fields(unmoved, {
  position: numbers<Transform['position']>(3, coordinate),
  rotation,
  scale: numberWithin(1 / coordinate, coordinate),
});
