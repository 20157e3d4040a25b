import { emptyScene, type Scene } from '../scene.ts';
import { environmentJson } from './environment-json.ts';
import type { Codecs } from './fields.ts';
import { posesJson } from './poses-json.ts';
import { shotsJson } from './shots-json.ts';

/** What a scene has beside its actors. To save another field, add its row. */
export type Surroundings = Omit<Scene, 'actors'>;

export const surroundingsJson: Codecs<Surroundings> = {
  environment: environmentJson,
  shots: shotsJson,
  poses: posesJson,
};

export const plainSurroundings: Surroundings = {
  environment: emptyScene.environment,
  shots: emptyScene.shots,
  poses: emptyScene.poses,
};
