import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import type { ClipParts } from '../core/motion/clip-parts.ts';
import { readBoundMotion } from '../formats/motion/read-bound-motion.ts';
import { fetchFile } from './fetch-file.ts';

/** Adds motions to the clips of a character; what is wrong with one is reported. */
export type AddMotions = (character: Character, problems: Diagnostic[]) => Character;

/**
 * Fetches the motions that come with a bundled character.
 *
 * @param addresses of the motions
 */
export async function fetchMotions(
  addresses: readonly URL[],
  signal: AbortSignal,
): Promise<AddMotions> {
  const files = await Promise.all(addresses.map((address) => fetchFile(address, signal)));
  return (character, problems) => {
    const clips = files.flatMap(({ path, bytes }): readonly ClipParts[] => {
      const { value, diagnostics } = readBoundMotion(path, bytes, character);
      problems.push(...diagnostics);
      return value ? [value] : [];
    });
    return { ...character, clips: [...character.clips, ...clips] };
  };
}
