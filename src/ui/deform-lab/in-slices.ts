import { turnOfPage } from '../../view/turn-of-page.ts';

/** The page waits at most about so long for a slice of work, in milliseconds. */
const sliceTime = 12;

/**
 * Does work that gives back the part that is done from time to time, in slices between which the page
 * goes on. Returns its result, or undefined if the signal stopped it.
 */
export async function inSlices<T>(
  work: Generator<number, T>,
  signal: AbortSignal,
  onProgress: (part: number) => void,
): Promise<T | undefined> {
  for (;;) {
    await turnOfPage();
    if (signal.aborted) {
      work.return(undefined as T); // so that it lets go of what it holds
      return undefined;
    }
    const end = performance.now() + sliceTime;
    for (;;) {
      const step = work.next();
      if (step.done) return step.value;
      if (performance.now() < end) continue;
      onProgress(step.value);
      break;
    }
  }
}
