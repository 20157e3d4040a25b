import type { Character } from '../core/character.ts';
import type { ChannelParts, ClipParts } from '../core/motion/clip-parts.ts';

/**
 * A character whose joints have the numbers that files give them which nest joints in one another:
 * depth first, which is the order in which they are stored.
 */
export function numberedDepthFirst(character: Character): Character {
  const stored = Uint16Array.from(character.skeleton.parents.keys());
  const skeleton = { ...character.skeleton, sourceIndex: stored, jointOfSource: stored };
  return { ...character, skeleton };
}

/** A clip of a character for the character that `numberedDepthFirst` makes of it. */
export function clipDepthFirst(
  clip: ClipParts,
  { jointOfSource }: Character['skeleton'],
): ClipParts {
  const channels = clip.channels.map((channel) => {
    const { target } = channel;
    if (!target || target.of === 'morph') return channel;
    const joint = jointOfSource[target.joint];
    return joint === undefined
      ? channel
      : ({ ...channel, target: { ...target, joint } } as ChannelParts);
  });
  return { ...clip, channels };
}
