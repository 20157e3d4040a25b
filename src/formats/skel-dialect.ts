import type { FileEntry } from './format.ts';
import { decodeText } from './text/decode-text.ts';

/**
 * Both courses call their skeletons `.skel`: CSE169's is made of `balljoint NAME { … }`, 6.837's of
 * nothing but numbers and comments.
 */
export function skelDialect({ head }: FileEntry): 'mit' | 'cse169' {
  return /balljoint|\{/i.test(decodeText(head)) ? 'cse169' : 'mit';
}
