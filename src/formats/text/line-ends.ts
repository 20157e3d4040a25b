const tab = 0x09;
export const lineFeed = 0x0a;
export const carriageReturn = 0x0d;
const space = 0x20;

/**
 * Returns where the next line starts, after the line end at `start`: LF, CRLF and CR CR LF are one
 * line end each; carriage returns without a line feed are one line end each.
 */
export function endOfLineEnd(bytes: Uint8Array, start: number): number {
  if (bytes[start] !== carriageReturn) return start + 1;
  if (bytes[start + 1] === lineFeed) return start + 2;
  return bytes[start + 1] === carriageReturn && bytes[start + 2] === lineFeed
    ? start + 3
    : start + 1;
}

export function isBlank(byte: number): boolean {
  return byte === space || (byte >= tab && byte <= carriageReturn);
}
