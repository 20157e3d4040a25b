import type { Pass } from '../pass.ts';
import { backdropPass } from './backdrop.ts';
import { floorPass } from './floor.ts';
import { meshPass } from './mesh.ts';

/** The passes of the first picture; the others are loaded after it. */
export const firstPasses: readonly Pass[] = [floorPass, backdropPass, meshPass];

/**
 * The programs of the first picture, which are compiled while its character is read. Other programs
 * are compiled for the first picture that they are in.
 */
export const firstPrograms: readonly string[] = ['key-shadow', 'floor', 'backdrop', 'mesh'];
