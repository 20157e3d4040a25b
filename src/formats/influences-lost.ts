import { influencesOf, type Skin } from '../core/skin.ts';
import { byStrength } from '../core/strongest-influences.ts';

/** What is lost of a skin if each point keeps only its `most` strongest weights. */
export interface InfluencesLost {
  readonly pointCount: number;
  /** The largest part of a point's weights, from 0 to 1. */
  readonly largestShare: number;
}

export function influencesLost(skin: Skin, most: number): InfluencesLost {
  let pointCount = 0;
  let largestShare = 0;
  for (let point = 0; point + 1 < skin.start.length; point++) {
    if (skin.start[point + 1]! - skin.start[point]! <= most) continue;
    const sizes = byStrength(influencesOf(skin, point)).map(({ weight }) => Math.abs(weight));
    const sumOfSizes = (from: number): number => {
      return sizes.slice(from).reduce((sum, size) => sum + size, 0);
    };
    pointCount++;
    largestShare = Math.max(largestShare, sumOfSizes(most) / sumOfSizes(0));
  }
  return { pointCount, largestShare };
}
