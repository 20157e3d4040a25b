import { expect } from '@playwright/test';
import { drop, openApp } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, test } from './support/test.ts';

// A small view is drawn faster, and its size does not matter here.
test.use({ ...coarse, viewport: { width: 960, height: 420 } });

const names = [
  '<img src=x onerror=alert(1)>',
  '"><script>alert(1)',
  '\u202Egnp.lekes\u202C',
  '__proto__',
  'constructor',
  'x'.repeat(10_000),
  '名前 🦴 naïve',
];

test('names with markup, bidirectional controls and special words are shown as text everywhere', async ({
  page,
}) => {
  await openApp(page, 'model=tube');
  const elements = await page.locator('*').count();
  for (const name of names) {
    const files = madeCharacter(5, 2).map((file) => ({
      ...file,
      name: file.name.replace('made', name),
    }));
    await drop(page, files);
    expect(await page.evaluate(() => window.sinew.characters[0]!.name)).toBe(name);
    // A file with a problem shows its name in the panel of problems too.
    await drop(page, [{ name: `${name}.skel`, content: 'x' }]);
    await expect(page.locator('.problems')).toBeVisible();
    await page.getByRole('button', { name: 'Dismiss' }).click();
  }
  expect(await page.locator('img, script:not([src])').count()).toBe(0);
  expect(await page.locator('*').count()).toBeLessThan(elements + 200);
  const { scrollWidth, clientWidth } = await page.evaluate(() => document.documentElement);
  expect(scrollWidth, 'no name widens the page').toBe(clientWidth);
});
