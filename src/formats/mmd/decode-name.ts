const decoder = new TextDecoder('shift_jis');

/**
 * Text of a field: Shift-JIS up to the first NUL, cut before it is decoded, since what follows is
 * padding of any kind. A character that the field's end cuts in two becomes U+FFFD.
 */
export function decodeName(field: Uint8Array): string {
  const end = field.indexOf(0);
  return decoder.decode(end === -1 ? field : field.subarray(0, end));
}
