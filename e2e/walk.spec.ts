import { expect, type Page } from '@playwright/test';
import { randomSource } from '../tests/support/random.ts';
import { openApp } from './support/app.ts';
import { test } from './support/test.ts';

// Ten random runs over the page with every panel open: whatever is opened, added, removed, posed, selected
// and undone, nothing is thrown, and the scene can be told and verified.
test.use({ viewport: { width: 760, height: 420 } });

const stepsOfRun = 14;

type Step = (page: Page, number: number) => Promise<unknown>;

const pick = (page: Page, selector: string, number: number): Promise<void> =>
  page.evaluate(
    ([selector, number]) => {
      const found = document.querySelectorAll<HTMLElement>(selector);
      found[number % Math.max(found.length, 1)]?.click();
    },
    [selector, number] as const,
  );

const press = (page: Page, key: string): Promise<void> => page.keyboard.press(key);

/** What a user does next; numbers choose among what there is. */
const steps: readonly Step[] = [
  (page, number) => page.evaluate((id) => window.sinew.open(id), bundled(number)),
  (page, number) => page.evaluate((id) => window.sinew.add(id), bundled(number)),
  (page, number) => pick(page, '.scene-list button', number),
  (page, number) => pick(page, '[role=treeitem]', number),
  (page, number) => pick(page, '.lil-title', number),
  (page, number) =>
    page.evaluate((number) => {
      const { joints } = window.sinew.characters.find((each) => each.selected)!;
      window.sinew.pose({ joints: { [joints[number % joints.length]!]: [0.1, 0.2, 0.3] } });
    }, number),
  (page) => press(page, 'Control+z'),
  (page) => press(page, 'Control+z'),
  (page) => press(page, 'Control+Shift+z'),
  (page) => press(page, 'Control+d'),
  (page) => press(page, ']'),
  (page) => press(page, 'p'),
  (page) => press(page, 'm'),
  (page) => press(page, 'x'),
  async (page, number) => {
    const box = (await page.locator('canvas').boundingBox())!;
    const [x, y] = [(number % 97) / 97, (number % 89) / 89];
    await page.mouse.move(box.x + box.width * x, box.y + box.height * y);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * y, box.y + box.height * x, { steps: 2 });
    if (number % 3 === 0) await press(page, 'Escape');
    if (number % 5 === 0) await press(page, 'Control+z');
    await page.mouse.up();
  },
  async (page) => {
    const count = await page.evaluate(() => window.sinew.characters.length);
    if (count > 1) await page.evaluate(() => window.sinew.remove());
  },
];

function bundled(number: number): string {
  return ['tube', 'hand', 'insect', 'tube'][number % 4]!;
}

test('random use of the page ends in no error, and the numbers hold', async ({ page }) => {
  test.setTimeout(120_000);
  await openApp(page, 'model=tube');
  // Every folder of the controls, and the bone's panel.
  await page.evaluate(() => {
    for (const title of document.querySelectorAll<HTMLElement>('.lil-closed > .lil-title')) {
      if (!title.closest('.joints')) title.click();
    }
    document.querySelector<HTMLElement>('details.bone summary')?.click();
  });
  for (let seed = 1; seed <= 10; seed++) {
    const random = randomSource(seed);
    for (let i = 0; i < stepsOfRun; i++) {
      const step = steps[Math.floor(random() * steps.length)]!;
      await step(page, Math.floor(random() * 1000));
    }
    await page.evaluate(() => window.sinew.settled());
    const characters = await page.evaluate(() => window.sinew.characters);
    expect(characters.filter(({ selected }) => selected)).toHaveLength(1);
    for (const { id } of characters) {
      expect(await page.evaluate((id) => window.sinew.verify(id), id)).toMatchObject({
        identical: true,
      });
    }
    while ((await page.evaluate(() => window.sinew.characters.length)) > 3) {
      await page.evaluate(() => window.sinew.remove());
    }
  }
});
