import type { Browser, CDPSession, Page } from '@playwright/test';
import type { Contender } from '../harness/measure.ts';
import type { FrameKind } from './page.ts';

/** Opens a page that offers frames. */
export async function openPage(browser: Browser, address: string): Promise<Page> {
  const page = await browser.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.message));
  await page.goto(address);
  await page
    .waitForFunction(() => 'frameBench' in window, null, { timeout: 60_000 })
    .catch(() => {
      throw new Error(`${address} does not start: ${errors.join('; ')}`);
    });
  return page;
}

/** The time of one sample, in milliseconds, or one frame if that takes longer. */
const sampleMilliseconds = 60;

/**
 * @param clock a session of the browser, which tells its processor time
 */
export function frameContender(
  id: string,
  page: Page,
  kind: FrameKind,
  clock: CDPSession,
): Contender {
  let next = 0;
  let count = 1;
  return {
    id,
    async sample() {
      const before = await cpuMilliseconds(clock);
      const sample = await page.evaluate(
        ([kind, first, count]) => window.frameBench.sample(kind, first, count),
        [kind, next, count] as const,
      );
      const cpu = ((await cpuMilliseconds(clock)) - before) / count;
      next += count;
      count = Math.max(1, Math.min(20, Math.round(sampleMilliseconds / sample.wall)));
      return { ...sample, cpu };
    },
  };
}

/** The processor time of all processes of the browser so far, in steps of about 10 milliseconds. */
async function cpuMilliseconds(clock: CDPSession): Promise<number> {
  const { processInfo } = await clock.send('SystemInfo.getProcessInfo');
  return processInfo.reduce((sum, { cpuTime }) => sum + cpuTime * 1000, 0);
}
