import type { FileEntry } from '../format.ts';
import { headTokens } from '../text/head-tokens.ts';

/** A `.skel` of CSE169 is made of `balljoint NAME { … }`; rich text, which has braces too, is none. */
export function isCse169File({ head }: FileEntry): boolean {
  const tokens = headTokens(head);
  return /balljoint/i.test(tokens) || (tokens.includes('{') && !tokens.startsWith('{\\rtf'));
}
