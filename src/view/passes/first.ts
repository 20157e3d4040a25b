import type { Pass } from '../pass.ts';
import { backdropPass } from './backdrop.ts';
import { floorPass } from './floor.ts';
import { meshPass } from './mesh.ts';

/** The passes of the first picture; the others are loaded after it. */
export const firstPasses: readonly Pass[] = [floorPass, backdropPass, meshPass];
