/**
 * Returns all buffers of the typed arrays anywhere in a plain value, without duplicates, as a
 * transfer list.
 */
export function buffersOf(value: unknown): ArrayBuffer[] {
  const buffers = new Set<ArrayBuffer>();
  collect(value);
  return [...buffers];

  function collect(part: unknown): void {
    if (ArrayBuffer.isView(part)) {
      if (part.buffer instanceof ArrayBuffer) buffers.add(part.buffer);
    } else if (typeof part === 'object' && part !== null) Object.values(part).forEach(collect);
  }
}
