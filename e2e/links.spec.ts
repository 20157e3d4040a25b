import { expect, type Page } from '@playwright/test';
import { capture, setPose } from './support/app.ts';
import { test } from './support/test.ts';

test.use({
  viewport: { width: 960, height: 420 },
  permissions: ['clipboard-read', 'clipboard-write'],
});

async function visit(page: Page, hash = ''): Promise<void> {
  await page.goto(`./?test${hash}`);
  await page.evaluate(() => window.sinew.ready);
  await page.evaluate(() => window.sinew.settled());
}

const status = (page: Page) => page.locator('.status');
const names = (page: Page) => page.evaluate(() => window.sinew.characters.map(({ name }) => name));

async function copyLink(page: Page): Promise<string> {
  await page.evaluate(() =>
    document.querySelector<HTMLElement>('[data-command="copy-link"]')!.click(),
  );
  await expect(status(page)).toContainText('Link copied');
  const link = await page.evaluate(() => navigator.clipboard.readText());
  return link.slice(link.indexOf('#'));
}

test.describe.configure({ timeout: 90_000 });

test('a link opens the same picture on a fresh page, by the byte', async ({ page, browser }) => {
  await visit(page);
  await page.evaluate(() => window.sinew.add('insect'));
  await setPose(page, { joints: { '#3': [0.1, 0.2, 0.3] } });
  await page.evaluate(() => window.sinew.seek(0.37));
  await page.locator('canvas').focus();
  for (const key of ['ArrowLeft', 'ArrowUp', 's', 'a']) await page.keyboard.press(key);
  const picture = await capture(page);
  const hash = await copyLink(page);
  const poses = await page.evaluate(() =>
    window.sinew.characters.map(({ id }) => window.sinew.pose(undefined, id)),
  );

  const fresh = await (
    await browser.newContext({ viewport: { width: 960, height: 420 } })
  ).newPage();
  await visit(fresh, hash);
  expect(await names(fresh)).toEqual(await names(page));
  expect(
    await fresh.evaluate(() =>
      window.sinew.characters.map(({ id }) => window.sinew.pose(undefined, id)),
    ),
  ).toEqual(poses);
  expect((await capture(fresh)).equals(picture), 'the same picture').toBe(true);
  await fresh.context().close();
});
