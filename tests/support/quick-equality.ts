import { expect } from 'vitest';

/**
 * Typed arrays of equal bytes are equal; `toEqual` would compare each element, which takes seconds
 * for the arrays of whole characters. Where bytes differ, it still decides, and reports.
 */
function sameBytes(a: unknown, b: unknown): true | undefined {
  if (!isTyped(a) || !isTyped(b) || a.constructor !== b.constructor) return undefined;
  if (a.byteLength !== b.byteLength) return undefined;
  const bytesOf = ({ buffer, byteOffset, byteLength }: NodeJS.TypedArray) =>
    Buffer.from(buffer, byteOffset, byteLength);
  return bytesOf(a).equals(bytesOf(b)) ? true : undefined;
}

function isTyped(value: unknown): value is NodeJS.TypedArray {
  return ArrayBuffer.isView(value) && !(value instanceof DataView);
}

// Test files share a process, and each loads this file anew.
const added = Symbol.for('sinew quick equality');
if (!(added in globalThis)) {
  Object.assign(globalThis, { [added]: true });
  expect.addEqualityTesters([sameBytes]);
}
