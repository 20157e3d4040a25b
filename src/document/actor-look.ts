import type { CharacterImage } from '../core/character.ts';

export type Shading = 'smooth' | 'faceted';

/** What covers an actor: its files' materials, clay alone, an image, a checker, or (u, v) as color. */
export type SurfaceKind = 'file' | 'clay' | 'image' | 'checker' | 'uv';

/**
 * How an image or a checker lies on the surface: by texture coordinates, or projected in the bind
 * pose from the six sides of a box or around a cylinder.
 */
export type Projection = 'uv' | 'box' | 'cylinder';

/** How a dragged bone turns: its grabbed point follows the pointer, or as in CS354's program. */
export type BoneDrag = 'follow' | 'course';

/** How an actor is drawn, apart from its materials, and how it is handled. */
export interface ActorLook {
  /** A hidden actor is neither drawn nor picked, and casts no shadow. */
  readonly visible: boolean;
  /** The color of what has no material: an index, below `clayCount`, into the studio's clays. */
  readonly clay: number;
  /** From 0, which is polished, to 1, which is matte. */
  readonly roughness: number;
  readonly shading: Shading;
  readonly dragging: BoneDrag;
  readonly surface: SurfaceKind;
  /** A mesh without texture coordinates has `box` in place of `uv`. */
  readonly projection: Projection;
  /**
   * How often the image, or the checker's square of checks, repeats over the texture coordinates
   * from 0 to 1, or projected, over the height.
   */
  readonly repeats: number;
  /** The image of the surface `image`. */
  readonly image: CharacterImage | null;
}

/** The smallest and the largest `repeats`. */
export const repeatsRange = [0.01, 1000] as const;

/** The number of clays. */
export const clayCount = 8;

export const plainLook: ActorLook = {
  visible: true,
  clay: 0,
  roughness: 1,
  shading: 'smooth',
  dragging: 'follow',
  surface: 'file',
  projection: 'uv',
  repeats: 1,
  image: null,
};

/** Returns the first of the clays that the fewest of these looks have. */
export function nextClay(looks: readonly Pick<ActorLook, 'clay'>[]): number {
  const uses = new Array<number>(clayCount).fill(0);
  for (const { clay } of looks) uses[clay]! += 1;
  return uses.indexOf(Math.min(...uses));
}
