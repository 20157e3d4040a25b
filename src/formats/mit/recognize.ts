import type { FileEntry } from '../format.ts';
import { headTokens } from '../text/head-tokens.ts';

/** A `.skel` of 6.837 consists of only numbers and comments; that of CSE169 has braces. */
export function isMitFile({ head }: FileEntry): boolean {
  return !/balljoint|\{/i.test(headTokens(head));
}
