import { decodeText } from './decode-text.ts';

/** Comments of any format, including one that is not closed. */
const comments = /(#|\/\/).*|\/\*[^]*?(\*\/|$)/g;

/**
 * The beginning of a text without its comments, from which formats are recognized. Comments are
 * removed because they may contain any word.
 */
export function headTokens(head: Uint8Array): string {
  const text = decodeText(head);
  return text.replace(comments, '').trim() || text;
}
