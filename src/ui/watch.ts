import { effect, type ReadonlySignal } from '@preact/signals-core';

/**
 * Runs `run` now and whenever one of the signals changes, for functions that read signals
 * indirectly.
 */
export function watch(signals: readonly ReadonlySignal<unknown>[], run: () => void): void {
  effect(() => {
    // Reading a signal's value subscribes to it.
    if (signals.every((signal) => signal.value !== undefined)) run();
  });
}
