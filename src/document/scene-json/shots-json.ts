import { startCamera } from '../camera.ts';
import { aspects, type Shot } from '../shots.ts';
import { cameraJson } from './camera-json.ts';
import { checked, type Codec, index, listOf, oneOf, text } from './codec.ts';
import { fields } from './fields.ts';

const plainShot: Shot = { id: 0, name: 'Shot', camera: startCamera, aspect: 'view' };

const shot = fields(plainShot, {
  id: index,
  name: text,
  camera: cameraJson,
  aspect: oneOf(aspects.map(({ id }) => id)),
});

/** More shots than a list is good for. */
const mostShots = 1000;

export const shotsJson: Codec<readonly Shot[]> = checked(
  listOf(shot, mostShots),
  (shots) => new Set(shots.map(({ id }) => id)).size === shots.length,
  'shots whose ids differ',
);
