import { effect, type ReadonlySignal } from '@preact/signals-core';

/** Runs now and whenever one of the signals changes, for work that reads them out of sight. */
export function watch(signals: readonly ReadonlySignal<unknown>[], run: () => void): void {
  effect(() => {
    // To read a signal's value is to follow it.
    if (signals.every((signal) => signal.value !== undefined)) run();
  });
}
