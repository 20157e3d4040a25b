import { computed, effect, type ReadonlySignal } from '@preact/signals-core';

/** Runs now and whenever one of the signals changes, for work that reads them out of sight. */
export function watch(signals: readonly ReadonlySignal[], run: () => void): void {
  const values = computed(() => signals.map((signal) => signal.value));
  effect(() => {
    if (values.value.length > 0) run();
  });
}
