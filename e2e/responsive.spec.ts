import { expect, type Page } from '@playwright/test';
import { openApp } from './support/app.ts';
import { countedUser } from './support/counted-user.ts';
import { courseCharacter } from './support/course-character.ts';
import { mainThreadTasks } from './support/main-thread.ts';
import { coarse, openBundled, test } from './support/test.ts';

// A press is answered while a character loads. Machines differ in speed, so this counts the turns
// that the page got meanwhile, and only notes how long its tasks were.
test.use({ ...coarse, viewport: { width: 900, height: 480 } });

/** While a worker reads; a page that reads by itself has none. */
const leastTurns = 5;

interface Waiting {
  turns: number;
  /** How many of them there were while a worker had work. */
  whileReading: number;
  /** How many turns there were when a press was answered. */
  answeredAt: number | null;
  /** How many turns there were when the characters became others. */
  cameAt: number | null;
}

declare global {
  interface Window {
    waiting: Waiting;
  }
}

/** Counts turns of the page from now on, until it shows other characters. */
async function watch(page: Page): Promise<void> {
  await page.evaluate(() => {
    const waiting: Waiting = { turns: 0, whileReading: 0, answeredAt: null, cameAt: null };
    window.waiting = waiting;
    const busy = new Set<Worker>();
    const NativeWorker = Worker;
    window.Worker = class extends NativeWorker {
      override postMessage(
        message: unknown,
        options?: StructuredSerializeOptions | Transferable[],
      ): void {
        busy.add(this);
        super.postMessage(message, options as StructuredSerializeOptions);
      }
      override terminate(): void {
        busy.delete(this);
        super.terminate();
      }
    };
    const axes = document.querySelector('.view-switches [data-command="axes"]')!;
    new MutationObserver(() => (waiting.answeredAt ??= waiting.turns)).observe(axes, {
      attributeFilter: ['aria-pressed'],
    });
    const ids = (): string => window.sinew.characters.map(({ id }) => id).join();
    const before = ids();
    const turn = (): void => {
      waiting.turns++;
      if (busy.size > 0) waiting.whileReading++;
      if (ids() === before) setTimeout(turn);
      else waiting.cameAt = waiting.turns;
    };
    turn();
  });
}

/** Presses a switch at once after something began to load. */
async function expectAnswer(page: Page, begin: () => Promise<void>): Promise<void> {
  const box = (await page.locator('.view-switches [data-command="axes"]').boundingBox())!;
  await watch(page);
  await begin();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await expect.poll(() => page.evaluate(() => window.waiting.cameAt)).not.toBeNull();
  const { answeredAt, cameAt, whileReading } = await page.evaluate(() => window.waiting);
  expect(answeredAt, 'the press was answered').not.toBeNull();
  expect(answeredAt!, 'before the character came').toBeLessThan(cameAt!);
  expect(whileReading, 'turns while it was read').toBeGreaterThanOrEqual(leastTurns);
  expect(await page.evaluate(() => window.sinew.problems)).toEqual([]);
}

test('a press is answered while dropped files of 5 MB are read', async ({ page }) => {
  const files = courseCharacter(22);
  expect(files.reduce((sum, { content }) => sum + content.length, 0)).toBeGreaterThan(4e6);
  const tasks = await mainThreadTasks(page);
  await openApp(page, 'model=tube');
  const user = countedUser(page);
  const long = await tasks.during(() =>
    expectAnswer(page, () => user.drop(files, { x: 400, y: 200 })),
  );
  const description = long.map(({ duration }) => `${Math.round(duration)} ms`).join(', ');
  test.info().annotations.push({ type: 'main-thread tasks over 50 ms', description });
});

test('a press is answered while the second character of the first visit comes', async ({
  page,
}) => {
  await openBundled(page, 'whole');
  let handOut = (): void => undefined;
  const asked = new Promise<void>((resolve) => (handOut = resolve));
  await page.route('**/dog.*', async (route) => {
    await asked;
    await route.continue();
  });
  await page.goto('./');
  await page.evaluate(() => window.sinew.ready);
  await expect(page.locator('[data-section]:not([hidden]):empty')).toHaveCount(0);
  await expectAnswer(page, () => {
    handOut();
    return Promise.resolve();
  });
});
