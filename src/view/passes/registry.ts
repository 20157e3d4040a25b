import type { Pass } from '../pass.ts';
import './later-shaders.ts';
import { axesPass } from './axes.ts';
import { backdropPass } from './backdrop.ts';
import { boneLinesPass } from './bone-lines.ts';
import { floorPass } from './floor.ts';
import { meshPass } from './mesh.ts';
import { hiddenSkeletonPass, skeletonPass } from './skeleton.ts';

/** All passes, in the order of drawing. */
export const passes: readonly Pass[] = [
  floorPass,
  backdropPass,
  skeletonPass,
  meshPass,
  hiddenSkeletonPass,
  boneLinesPass,
  axesPass,
];
