import type { FileEntry } from './format.ts';
import { decodeText } from './text/decode-text.ts';

/** Of either course, whether they end or not. */
const comments = /(#|\/\/).*|\/\*[^]*?(\*\/|$)/g;

/**
 * Both courses call their skeletons `.skel`: CSE169's is made of `balljoint NAME { … }`, 6.837's of
 * nothing but numbers and comments. Comments may hold any word; they tell only where nothing else is.
 */
export function skelDialect({ head }: FileEntry): 'mit' | 'cse169' {
  const text = decodeText(head);
  const tokens = text.replace(comments, '').trim();
  return /balljoint|\{/i.test(tokens || text) ? 'cse169' : 'mit';
}
