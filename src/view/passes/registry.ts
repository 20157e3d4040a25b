import type { Pass } from '../pass.ts';
import './later-shaders.ts';
import { axesPass } from './axes.ts';
import { backdropPass } from './backdrop.ts';
import { boneLinesPass } from './bone-lines.ts';
import { checkerboardPass } from './checkerboard.ts';
import { floorPass } from './floor.ts';
import { litLimbPass } from './lit-limb.ts';
import { meshPass } from './mesh.ts';
import { normalLinesPass } from './normal-lines.ts';
import { overlayPass } from './overlay.ts';
import { planarShadowPass } from './planar-shadow.ts';
import { reflectionPass } from './reflection.ts';
import { hiddenSkeletonPass, skeletonPass } from './skeleton.ts';
import { weightsPass } from './weights.ts';

/** All passes, in the order of drawing. */
export const passes: readonly Pass[] = [
  floorPass,
  planarShadowPass,
  reflectionPass,
  backdropPass,
  skeletonPass,
  meshPass,
  weightsPass,
  checkerboardPass,
  litLimbPass,
  normalLinesPass,
  hiddenSkeletonPass,
  boneLinesPass,
  overlayPass,
  axesPass,
];
