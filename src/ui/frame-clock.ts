/** The time in seconds, and what runs with every picture. */
export interface FrameClock {
  now(): number;
  /** Runs a task before each picture, with its time, until the returned function is called. */
  everyFrame(task: (seconds: number) => void): () => void;
}

/** The clock of the page. */
export const pageClock: FrameClock = {
  now: () => performance.now() / 1000,
  everyFrame(task) {
    const run = (): void => {
      request = requestAnimationFrame(run);
      task(performance.now() / 1000);
    };
    let request = requestAnimationFrame(run);
    return () => {
      cancelAnimationFrame(request);
    };
  },
};
