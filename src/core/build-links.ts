import type { CharacterParts, IkChain, RotationLink } from './character-parts.ts';
import type { Skeleton } from './skeleton.ts';

/** Returns what links joints with each other, by their indices in the skeleton. */
export function buildLinks(
  { rotationLinks = [], ikChains = [] }: Pick<CharacterParts, 'rotationLinks' | 'ikChains'>,
  { jointOfSource }: Skeleton,
): { readonly rotationLinks: readonly RotationLink[]; readonly ikChains: readonly IkChain[] } {
  const jointOf = (source: number): number => jointOfSource[source]!;
  return {
    rotationLinks: rotationLinks.map(({ joint, source, ratio }) => ({
      joint: jointOf(joint),
      source: jointOf(source),
      ratio,
    })),
    ikChains: ikChains.map(({ goal, effector, links }) => ({
      goal: jointOf(goal),
      effector: jointOf(effector),
      links: links.map(jointOf),
    })),
  };
}
