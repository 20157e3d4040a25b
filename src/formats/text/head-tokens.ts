import { decodeText } from './decode-text.ts';

/** Of any course, whether they end or not. */
const comments = /(#|\/\/).*|\/\*[^]*?(\*\/|$)/g;

/**
 * The beginning of a text without its comments, for a format to know its files by. Comments may hold any
 * word; they tell only where nothing else is.
 */
export function headTokens(head: Uint8Array): string {
  const text = decodeText(head);
  return text.replace(comments, '').trim() || text;
}
