import { type Light, studio } from '../environment.ts';
import { color, listOf, numberWithin, text } from './codec.ts';
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

/** More lights than any shader has. */
const mostLights = 64;

export const environmentJson = fields(studio, { lights: listOf(light, mostLights) });
