const decoder = new TextDecoder('shift_jis');

/**
 * Decodes the text of a field: Shift-JIS up to the first NUL. The field is cut before decoding,
 * because arbitrary padding follows the NUL. A character that the end of the field cuts in two
 * becomes U+FFFD.
 */
export function decodeName(field: Uint8Array): string {
  const end = field.indexOf(0);
  return decoder.decode(end === -1 ? field : field.subarray(0, end));
}
