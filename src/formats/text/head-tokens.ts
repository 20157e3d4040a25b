import { decodeText } from './decode-text.ts';
import { carriageReturn, isBlank, lineFeed } from './line-ends.ts';

const hash = 0x23;
const star = 0x2a;
const slash = 0x2f;

/**
 * Returns where the first token of a text starts, after blanks and comments of any format. Returns
 * 0 if there is none.
 */
export function startOfTokens(bytes: Uint8Array): number {
  let at = 0;
  while (at < bytes.length) {
    const isSlash = bytes[at] === slash;
    if (isBlank(bytes[at]!)) at++;
    else if (bytes[at] === hash || (isSlash && bytes[at + 1] === slash)) at = endOfLine(bytes, at);
    else if (isSlash && bytes[at + 1] === star) at = endOfComment(bytes, at);
    else return at;
  }
  return 0;
}

function endOfLine(bytes: Uint8Array, start: number): number {
  let at = start;
  while (at < bytes.length && bytes[at] !== lineFeed && bytes[at] !== carriageReturn) at++;
  return at;
}

function endOfComment(bytes: Uint8Array, start: number): number {
  let at = start + 2;
  while (at < bytes.length && !(bytes[at] === star && bytes[at + 1] === slash)) at++;
  return at + 2;
}

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
