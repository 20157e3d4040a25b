import type { Signal } from '@preact/signals-core';

/** What lil-gui reads and writes, over a signal. */
export function signalField<T>(signal: Signal<T>): { value: T } {
  return field(
    () => signal.value,
    (value) => (signal.value = value),
  );
}

/** What lil-gui reads and writes, by two functions. */
export function field<T>(get: () => T, set: (value: T) => void): { value: T } {
  return Object.defineProperty({} as { value: T }, 'value', { get, set, enumerable: true });
}
