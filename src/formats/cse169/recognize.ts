import type { FileEntry } from '../format.ts';
import { headTokens } from '../text/head-tokens.ts';

/**
 * A `.skel` of CSE169 consists of `balljoint NAME { … }`. Rich text, which has braces too, is
 * excluded.
 */
export function isCse169File({ head }: FileEntry): boolean {
  const tokens = headTokens(head);
  return /balljoint/i.test(tokens) || (tokens.includes('{') && !tokens.startsWith('{\\rtf'));
}
