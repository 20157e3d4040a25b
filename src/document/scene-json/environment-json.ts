import { type Light, studio } from '../environment.ts';
import { checked, color, listOf, numberWithin, oneOf, text } from './codec.ts';
import { fields } from './fields.ts';

const plainLight: Light = {
  name: 'Light',
  color: '#ffffff',
  intensity: 1,
  azimuth: 0,
  elevation: 45,
};

const light = fields(plainLight, {
  name: text,
  color,
  intensity: numberWithin(0, 1e6),
  azimuth: numberWithin(-1e6, 1e6),
  elevation: numberWithin(-1e6, 1e6),
});

const lightCount = studio.lights.length;

export const environmentJson = fields(studio, {
  // Every light has its own part in what shaders draw.
  lights: checked(
    listOf(light, lightCount),
    ({ length }) => length === lightCount,
    `a list of ${lightCount} lights`,
  ),
  ambient: fields(studio.ambient, { color, intensity: numberWithin(0, 1e6) }),
  shadow: fields(studio.shadow, {
    kind: oneOf(['mapped', 'planar', 'off']),
    darkness: numberWithin(0, 1),
  }),
  floor: fields(studio.floor, {
    kind: oneOf(['checks', 'plain', 'off']),
    reflection: numberWithin(0, 1),
  }),
  background: fields(studio.background, {
    kind: oneOf(['theme', 'color', 'gradient', 'transparent']),
    color,
    topColor: color,
  }),
});
