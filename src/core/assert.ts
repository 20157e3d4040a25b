/** Throws when a caller broke a contract. Bad *files* are values (`Parsed`), never exceptions. */
export function assert(condition: boolean, message: string): asserts condition {
  if (!condition) throw new Error(`Sinew contract broken: ${message}`);
}
