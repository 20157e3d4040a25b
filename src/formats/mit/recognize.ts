import type { FileEntry } from '../format.ts';
import { headTokens } from '../text/head-tokens.ts';

/** A `.skel` of 6.837 is made of nothing but numbers and comments; another course's has braces. */
export function isMitFile({ head }: FileEntry): boolean {
  return !/balljoint|\{/i.test(headTokens(head));
}
