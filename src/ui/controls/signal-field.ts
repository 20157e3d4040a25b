import type { Signal } from '@preact/signals-core';

/** Wraps a signal in a property that lil-gui can read and write. */
export function signalField<T>(signal: Signal<T>): { value: T } {
  return field(
    () => signal.value,
    (value) => (signal.value = value),
  );
}

/** Wraps two functions in a property that lil-gui can read and write. */
export function field<T>(get: () => T, set: (value: T) => void): { value: T } {
  return Object.defineProperty({} as { value: T }, 'value', { get, set, enumerable: true });
}
