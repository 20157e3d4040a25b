import { expect, type Page } from '@playwright/test';

/** A task that kept the page's main thread busy for more than 50 milliseconds. */
export interface LongTask {
  /** In milliseconds since the visit began. */
  readonly start: number;
  readonly duration: number;
}

declare global {
  interface Window {
    longTasks: LongTask[];
    /** When a worker last ended, in milliseconds since the visit began. */
    workerEnded: number;
  }
}

/** Notes the long tasks of a page that is not open yet, and when its workers end. */
export async function mainThreadTasks(page: Page) {
  await page.addInitScript(() => {
    window.longTasks = [];
    const terminate = Object.getOwnPropertyDescriptor(Worker.prototype, 'terminate')!;
    Worker.prototype.terminate = function () {
      window.workerEnded = performance.now();
      (terminate.value as () => void).call(this);
    };
    new PerformanceObserver((list) => {
      for (const { startTime, duration } of list.getEntries()) {
        window.longTasks.push({ start: startTime, duration });
      }
    }).observe({ type: 'longtask', buffered: true });
  });
  return {
    /** Returns the long tasks that begin during an action. */
    async during(action: () => Promise<unknown>): Promise<LongTask[]> {
      const begin = await page.evaluate(() => performance.now());
      await action();
      return page.evaluate(async (begin) => {
        const end = performance.now();
        // An entry is delivered after its task.
        await new Promise((resolve) => setTimeout(resolve, 100));
        return window.longTasks.filter(({ start }) => start >= begin && start < end);
      }, begin);
    },
  };
}

export function expectShortTasks(tasks: readonly LongTask[], longest: number): void {
  expect(tasks.filter(({ duration }) => duration > longest)).toEqual([]);
}
