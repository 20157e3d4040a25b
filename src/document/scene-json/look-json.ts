import { clayCount, plainLook } from '../actor-look.ts';
import { checked, flag, index, numberWithin, oneOf } from './codec.ts';
import { fields } from './fields.ts';

export const lookJson = fields(plainLook, {
  visible: flag,
  clay: checked(index, (clay) => clay < clayCount, `a whole number below ${clayCount}`),
  roughness: numberWithin(0, 1),
  shading: oneOf(['smooth', 'faceted']),
  dragging: oneOf(['follow', 'course']),
});
