import { expect, type Locator } from '@playwright/test';
import { PNG } from 'pngjs';
import { openApp } from './support/app.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use({ ...coarse, viewport: { width: 1000, height: 500 } });
const page = sharedPage(async (page) => {
  await openApp(page, 'model=human');
  await page.keyboard.press('v');
});

/** The differences of a pixel's channels, from 0 to 255, that are a color and no gray. */
const colorful = 60;

/** How many pixels of the view have a color. */
async function colored(): Promise<number> {
  const { data } = PNG.sync.read(await page().locator('canvas.scene').screenshot());
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    const [r, g, b] = [data[i]!, data[i + 1]!, data[i + 2]!];
    if (Math.max(r, g, b) - Math.min(r, g, b) > colorful) count++;
  }
  return count;
}

const row = (name: string): Locator => page().getByRole('treeitem', { name, exact: true });

// The skin is shown first, then the skeleton alone: each has to be lit and dimmed.
for (const [shown, presses] of [
  ['skin', 0],
  ['bone', 1],
] as const) {
  test(`a row of the list of joints lights its ${shown} and dims the rest, by pointer and by keys`, async () => {
    for (let i = 0; i < presses; i++) await page().keyboard.press('s');
    const lit = page().locator('[role=treeitem].lit');
    await page().mouse.move(600, 480);
    await expect(lit).toHaveCount(0);
    const all = await colored();
    const expectLit = async (name: string): Promise<void> => {
      await expect(lit).toHaveText(new RegExp(`${name}$`));
      await expect.poll(colored).toBeLessThan(all / 4);
      expect(await colored()).toBeGreaterThan(10);
    };
    await row('Chest').hover();
    await expectLit('Chest');
    await page().mouse.move(600, 480);
    await expect(lit).toHaveCount(0);
    await expect.poll(colored).toBe(all);
    await row('Chest').focus();
    await page().keyboard.press('ArrowDown');
    await expectLit('Neck');
    await row('Neck').evaluate((element) => element.blur());
    await expect.poll(colored).toBe(all);
  });
}
