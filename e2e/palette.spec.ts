import { expect } from '@playwright/test';
import { openApp } from './support/app.ts';
import { violations } from './support/axe.ts';
import { coarse, sharedPage, test } from './support/test.ts';

// The command palette finds and runs commands, and what is made from data, by keys and pointer.
test.use({ ...coarse, viewport: { width: 900, height: 480 } });
const page = sharedPage((page) => openApp(page, 'model=human'));

const palette = () => page().getByRole('dialog', { name: 'Commands' });
const field = () => page().getByRole('combobox', { name: 'Search the commands' });
const rows = () => palette().getByRole('option');
const active = () => palette().getByRole('option', { selected: true });

async function openPalette(): Promise<void> {
  await page().keyboard.press('Control+k');
  await expect(field()).toBeFocused();
}

test('a key opens the palette, and typing, Enter and Escape do the rest', async () => {
  await page().locator('canvas.scene').focus();
  await openPalette();
  await expect(active()).toHaveCount(1);
  const first = await rows().first().getAttribute('id');
  await expect(field()).toHaveAttribute('aria-activedescendant', first!);
  expect(await violations(page(), { within: 'dialog' })).toEqual([]);

  // Letters are text here, and do not run the commands that have them as keys.
  await page().keyboard.type('duplicate ch');
  await expect(active()).toContainText('Duplicate the character');
  await expect(active().locator('kbd')).toHaveText('Ctrl/Cmd+D');
  await page().keyboard.press('Enter');
  await expect(palette()).toHaveCount(0);
  await expect.poll(() => page().evaluate(() => window.sinew.characters.length)).toBe(2);
  await expect(page().locator('canvas.scene')).toBeFocused();

  await openPalette();
  await page().keyboard.type('und');
  await page().keyboard.press('Enter');
  await expect(page().locator('output.notice')).toHaveText(/^Undid/);
  await openPalette();
  await page().keyboard.press('Escape');
  await expect(palette()).toHaveCount(0);
});

test('arrow keys move the active row past both ends, and into view', async () => {
  await openPalette();
  const count = await rows().count();
  expect(count).toBeGreaterThan(30);
  await page().keyboard.press('ArrowUp');
  await expect(rows().last()).toHaveAttribute('aria-selected', 'true');
  await expect(rows().last()).toBeInViewport();
  await page().keyboard.press('ArrowDown');
  await page().keyboard.press('ArrowDown');
  await expect(rows().nth(1)).toHaveAttribute('aria-selected', 'true');
  const id = await rows().nth(1).getAttribute('id');
  await expect(field()).toHaveAttribute('aria-activedescendant', id!);
  await page().keyboard.type('zzzz');
  await expect(rows()).toHaveCount(0);
  await expect(palette().getByRole('status')).toHaveText('Nothing fits');
  await page().keyboard.press('Enter');
  await expect(palette()).toBeVisible();
  // The same key closes the palette.
  await page().keyboard.press('Control+k');
  await expect(palette()).toHaveCount(0);
});

test('a joint found by its name has the focus on its first number', async () => {
  await openPalette();
  await page().keyboard.type('left fore');
  await expect(active()).toContainText('Select Left forearm');
  await page().keyboard.press('Enter');
  await expect(page().locator(':focus')).toHaveAttribute('aria-label', /^Left forearm/);
});

test('a press runs a row, and what was used lately comes first', async () => {
  await openPalette();
  await page().keyboard.type('op');
  await expect(rows().first()).toContainText('Open');
  await rows().filter({ hasText: 'Open Hand' }).click();
  await expect(palette()).toHaveCount(0);
  await expect
    .poll(() => page().evaluate(() => window.sinew.characters.map(({ name }) => name)))
    .toEqual(['hand']);
  await openPalette();
  await page().keyboard.type('opha');
  await expect(active()).toContainText('Open Hand');
  await page().keyboard.press('Escape');
  await expect(palette()).toHaveCount(0);
});

test('the palette fits a phone, and has no violations there in dark colors', async () => {
  await page().setViewportSize({ width: 390, height: 700 });
  await page().emulateMedia({ colorScheme: 'dark' });
  await openPalette();
  const box = (await palette().boundingBox())!;
  expect(box.x).toBeGreaterThanOrEqual(0);
  expect(box.x + box.width).toBeLessThanOrEqual(390);
  expect(box.y + box.height).toBeLessThanOrEqual(700);
  expect(await violations(page(), { within: 'dialog' })).toEqual([]);
});
