import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import type { ClipParts } from '../core/motion/clip-parts.ts';
import { readBoundMotion } from '../formats/motion/read-bound-motion.ts';
import { type CatalogueEntry, dataUrl } from './catalogue.ts';
import { fetchFile } from './fetch-file.ts';

/** Where the motions of a character are listed. */
type Listed = Pick<CatalogueEntry, 'motions'>;

/**
 * Returns a bundled character with the motions that come with it as further clips. The first picture
 * does not need them, so characters open without them. The same character gives the same one again.
 *
 * @param problems where what is wrong with a motion is reported
 */
export function withMotions(
  listed: Listed,
  character: Character,
  problems: Diagnostic[],
): Promise<Character> {
  if (!lacksMotions(listed, character)) return Promise.resolve(character);
  let found = known.get(character);
  if (!found) {
    known.set(character, (found = complete(listed, character, problems)));
    found.catch(() => known.delete(character)); // the next one who asks may have a connection
  }
  return found;
}

/** Whether motions come with a character that it does not have yet. */
export function lacksMotions({ motions }: Listed, character: Character): boolean {
  return motions !== undefined && !completed.has(character);
}

async function complete(
  { motions = [] }: Listed,
  character: Character,
  problems: Diagnostic[],
): Promise<Character> {
  const files = await Promise.all(motions.map((path) => fetchFile(new URL(path, dataUrl()))));
  const clips = files.flatMap(({ path, bytes }): readonly ClipParts[] => {
    const { value, diagnostics } = readBoundMotion(path, bytes, character);
    problems.push(...diagnostics);
    return value ? [value] : [];
  });
  const full = { ...character, clips: [...character.clips, ...clips] };
  completed.add(full);
  return full;
}

/** By the character without motions. */
const known = new WeakMap<Character, Promise<Character>>();
const completed = new WeakSet<Character>();
