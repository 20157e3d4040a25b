/**
 * Returns a function that runs at once, and again at most once a frame, then with the last value
 * that it was given.
 */
export function onceAFrame<T>(run: (value: T) => void): (value: T) => void {
  let isWaiting = false;
  let latest: { readonly value: T } | null = null;
  return function offer(value) {
    if (isWaiting) {
      latest = { value };
      return;
    }
    run(value);
    isWaiting = true;
    requestAnimationFrame(() => {
      isWaiting = false;
      const next = latest;
      latest = null;
      if (next) offer(next.value);
    });
  };
}
