import { clayCount, plainLook, repeatsRange } from '../actor-look.ts';
import { checked, flag, index, numberWithin, oneOf, orNull } from './codec.ts';
import { fields } from './fields.ts';
import { imageJson } from './image-json.ts';

export const lookJson = fields(plainLook, {
  visible: flag,
  clay: checked(index, (clay) => clay < clayCount, `a whole number below ${clayCount}`),
  roughness: numberWithin(0, 1),
  shading: oneOf(['smooth', 'faceted']),
  dragging: oneOf(['follow', 'course']),
  surface: oneOf(['file', 'clay', 'image', 'checker', 'uv']),
  projection: oneOf(['uv', 'box', 'cylinder']),
  repeats: numberWithin(...repeatsRange),
  image: orNull(imageJson),
});
