export type Shading = 'smooth' | 'faceted';

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
}

/** The number of clays. */
export const clayCount = 8;

export const plainLook: ActorLook = {
  visible: true,
  clay: 0,
  roughness: 1,
  shading: 'smooth',
  dragging: 'follow',
};

/** Returns the first of the clays that the fewest of these looks have. */
export function nextClay(looks: readonly Pick<ActorLook, 'clay'>[]): number {
  const uses = new Array<number>(clayCount).fill(0);
  for (const { clay } of looks) uses[clay]! += 1;
  return uses.indexOf(Math.min(...uses));
}
