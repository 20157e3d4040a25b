/**
 * Throws if a caller broke a contract. A bad *file* is never an exception; readers return it as a
 * `Parsed` value.
 */
export function assert(condition: boolean, message: string): asserts condition {
  if (!condition) throw new Error(`Sinew contract broken: ${message}`);
}
