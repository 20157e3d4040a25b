import type { KeyParts, Tangent, Tcb } from './clip-parts.ts';

/** The slopes of a curve at its keys, in value per second. */
export interface Slopes {
  /** (keyCount) before each key. */
  readonly slopesIn: Float64Array;
  /** (keyCount) after each key. */
  readonly slopesOut: Float64Array;
}

/**
 * What a rule knows about a key: the changes of value to it and from it, and how long they take. An
 * end has only one neighbor, and takes the only span for both.
 */
interface Neighborhood {
  readonly changeIn: number;
  readonly changeOut: number;
  /** In seconds. */
  readonly spanIn: number;
  readonly spanOut: number;
}

/** Computes the slopes of keys at increasing times from their tangents. */
export function slopesOf(keys: readonly KeyParts[]): Slopes {
  const slopesIn = new Float64Array(keys.length);
  const slopesOut = new Float64Array(keys.length);
  keys.forEach(({ tangentIn, tangentOut }, at) => {
    slopesIn[at] = slopeAt(keys, at, tangentIn, true);
    // Most rules give both sides the same slope.
    const isShared = tangentOut === tangentIn && isTwoSided(tangentOut);
    slopesOut[at] = isShared ? slopesIn[at] : slopeAt(keys, at, tangentOut, false);
  });
  return { slopesIn, slopesOut };
}

function isTwoSided(tangent: Tangent): boolean {
  return tangent === 'auto' || tangent === 'smooth';
}

function slopeAt(
  keys: readonly KeyParts[],
  at: number,
  tangent: Tangent,
  isBefore: boolean,
): number {
  if (typeof tangent === 'number') return tangent;
  if (tangent === 'flat' || tangent === 'stepped' || keys.length < 2) return 0;
  const near = neighborhood(keys, at);
  if (tangent === 'linear') {
    return isBefore ? near.changeIn / near.spanIn : near.changeOut / near.spanOut;
  }
  const isEnd = at === 0 || at === keys.length - 1;
  if (tangent === 'smooth') {
    if (isEnd) return near.changeIn / near.spanIn;
    return (near.changeIn + near.changeOut) / (near.spanIn + near.spanOut);
  }
  if (tangent === 'auto') return autoSlope(keys, at, near);
  if (isEnd) return (1 - tangent.tcb[0]) * (near.changeIn / near.spanIn);
  return tcbSlope(near, tangent.tcb, isBefore);
}

function neighborhood(keys: readonly KeyParts[], at: number): Neighborhood {
  const last = keys.length - 1;
  const before = Math.min(Math.max(at - 1, 0), last - 1);
  const after = Math.min(at, last - 1);
  return {
    changeIn: keys[before + 1]!.value - keys[before]!.value,
    changeOut: keys[after + 1]!.value - keys[after]!.value,
    spanIn: keys[before + 1]!.time - keys[before]!.time,
    spanOut: keys[after + 1]!.time - keys[after]!.time,
  };
}

/**
 * The slope of a monotone curve, which does not overshoot its keys: 0 at local extrema, otherwise a
 * weighted harmonic mean; at an end, the limited three-point formula. (Fritsch and Butland 1984,
 * "A method for constructing local monotone piecewise cubic interpolants".)
 */
function autoSlope(keys: readonly KeyParts[], at: number, near: Neighborhood): number {
  const last = keys.length - 1;
  if (at === 0 || at === last) {
    if (last === 1) return near.changeIn / near.spanIn;
    const next = neighborhood(keys, at === 0 ? 1 : last - 1);
    const own = near.changeIn / near.spanIn;
    const [otherChange, otherSpan] =
      at === 0 ? [next.changeOut, next.spanOut] : [next.changeIn, next.spanIn];
    return endSlope(near.spanIn, otherSpan, own, otherChange / otherSpan);
  }
  const { spanIn, spanOut } = near;
  const [slopeIn, slopeOut] = [near.changeIn / spanIn, near.changeOut / spanOut];
  if (slopeIn * slopeOut <= 0) return 0;
  const weightIn = 2 * spanOut + spanIn;
  const weightOut = spanOut + 2 * spanIn;
  return (weightIn + weightOut) / (weightIn / slopeIn + weightOut / slopeOut);
}

function endSlope(ownSpan: number, otherSpan: number, own: number, other: number): number {
  const slope = ((2 * ownSpan + otherSpan) * own - ownSpan * other) / (ownSpan + otherSpan);
  if (slope * own <= 0) return 0;
  return own * other <= 0 && Math.abs(slope) > 3 * Math.abs(own) ? 3 * own : slope;
}

/**
 * The slope by tension, continuity and bias, adjusted for spans of different lengths; at an end, only
 * the tension counts. (Kochanek and Bartels 1984, "Interpolating splines with local tension, continuity, and bias control".)
 */
function tcbSlope(near: Neighborhood, [tension, continuity, bias]: Tcb, isBefore: boolean): number {
  const side = isBefore ? -continuity : continuity;
  const fromIn = ((1 - tension) * (1 + side) * (1 + bias)) / 2;
  const fromOut = ((1 - tension) * (1 - side) * (1 - bias)) / 2;
  const change = fromIn * near.changeIn + fromOut * near.changeOut;
  return (2 * change) / (near.spanIn + near.spanOut);
}
