import { expect, type Page } from '@playwright/test';
import { randomSource } from '../tests/support/random.ts';
import { openApp } from './support/app.ts';
import { countHoldings } from './support/holdings.ts';
import {
  comeToRest,
  expectNoLeak,
  expectNumbers,
  expectReplay,
  restingHoldings,
} from './support/soak/checks.ts';
import { answerFileDialogs, type Dice, steps } from './support/soak/steps.ts';
import { coarse, test } from './support/test.ts';

// This uses the page at random. `npm run test:long -- soak --seed 3 --minutes 2` sets the seeds and
// the length.
test.use({ ...coarse, viewport: { width: 960, height: 420 } });

const seeds = (process.env['SOAK_SEEDS'] ?? '1').split(',').map(Number);
const seconds = 60 * Number(process.env['SOAK_MINUTES'] ?? 8 / 60);
const stepsBetweenChecks = 40;
/**
 * The addresses of saved files are kept for ten seconds, for browsers that fetch them late; one
 * more second allows for the event's way to this process.
 */
const keptMilliseconds = 11_000;
/**
 * A step that takes longer counts as a hang; the slowest takes some hundred milliseconds on an idle
 * machine.
 */
const longestStep = 30_000;

for (const seed of seeds) {
  test(`random use causes no fault: seed ${seed}`, async ({ page }) => {
    test.setTimeout(seconds * 1000 + 120_000);
    const log: string[] = [];
    const random = randomSource(seed);
    const dice: Dice = (count) => Math.floor(random() * count);
    try {
      await walk(page, dice, log);
    } catch (error) {
      const last = log.slice(-30).join('\n');
      const what = error instanceof Error ? error.message : String(error);
      throw new Error(`seed ${seed}, step ${log.length}: ${what}\nafter\n${last}`, {
        cause: error,
      });
    }
    test.info().annotations.push({ type: 'steps', description: String(log.length) });
  });
}

async function walk(page: Page, dice: Dice, log: string[]): Promise<void> {
  const faults: string[] = [];
  page.on('pageerror', (error) => faults.push(error.stack ?? error.message));
  page.on('console', (message) => {
    if (message.type() === 'error') faults.push(message.text());
  });
  const downloads: number[] = [];
  page.on('download', () => downloads.push(Date.now()));
  answerFileDialogs(page, dice);
  await countHoldings(page);
  await openApp(page, 'model=tube');
  await openPanels(page);
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('Performance.enable');

  const end = Date.now() + seconds * 1000;
  while (Date.now() < end) {
    for (let i = 0; i < stepsBetweenChecks && Date.now() < end; i++) {
      const step = chosen(dice);
      const entry = log.push(step.name) - 1;
      const done = await inTime(step.run(page, dice));
      log[entry] = `${step.name}: ${done}`;
      expect(faults).toEqual([]);
    }
    log.push('checks');
    await inTime(comeToRest(page));
    await expectNumbers(page);
    await inTime(expectReplay(page));
    const since = Date.now() - keptMilliseconds;
    const resting = await inTime(restingHoldings(page, devtools));
    // The word of a download may come late, so the recent ones are counted last.
    const recent = downloads.filter((time) => time > since).length;
    expectNoLeak(resting, recent);
    expect(faults).toEqual([]);
  }
}

/**
 * Opens every folder of the controls except the joints', and the bone panel, so that they have to
 * follow the scene.
 */
function openPanels(page: Page): Promise<void> {
  return page.evaluate(() => {
    for (const title of document.querySelectorAll<HTMLElement>('.lil-closed > .lil-title')) {
      if (!title.closest('.joints')) title.click();
    }
    document.querySelector<HTMLElement>('details.bone summary')?.click();
  });
}

/** Chooses a step at random, by weight. */
function chosen(dice: Dice): (typeof steps)[number] {
  let left = dice(steps.reduce((sum, { weight }) => sum + weight, 0));
  return steps.find(({ weight }) => (left -= weight) < 0)!;
}

function inTime<T>(work: Promise<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error('the page hangs')), longestStep);
    work.then(resolve, reject).finally(() => clearTimeout(timer));
  });
}
