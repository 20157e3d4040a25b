import type { KeyParts, Tangent } from '../clip-parts.ts';

/**
 * The tangents of a key of a curve whose time and value are multiplied by factors. Backward in time
 * the tangents change sides, and a bias its sign. Stepped spans have no counterpart: they keep the
 * value of the key that comes first.
 */
export function stretchedTangents(
  { tangentIn, tangentOut }: KeyParts,
  timeFactor: number,
  valueFactor: number,
): Pick<KeyParts, 'tangentIn' | 'tangentOut'> {
  const isBackward = timeFactor < 0;
  // Keys that are all put at one time have no slope that fits; theirs stay.
  const slopeFactor = timeFactor === 0 ? 1 : valueFactor / timeFactor;
  const stretched = (tangent: Tangent): Tangent => {
    if (typeof tangent === 'number') return tangent * slopeFactor;
    if (typeof tangent === 'string' || !isBackward) return tangent;
    const [tension, continuity, bias] = tangent.tcb;
    return { tcb: [tension, continuity, -bias] };
  };
  const [before, after] = isBackward ? [tangentOut, tangentIn] : [tangentIn, tangentOut];
  return { tangentIn: stretched(before), tangentOut: stretched(after) };
}
