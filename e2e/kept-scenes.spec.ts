import { expect, type BrowserContext, type Page } from '@playwright/test';
import { capture, drop, getPose, setPose } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { test } from './support/test.ts';

test.use({ viewport: { width: 960, height: 420 } });
test.describe.configure({ timeout: 90_000 });

async function visit(context: BrowserContext, query = ''): Promise<Page> {
  const page = await context.newPage();
  await page.goto(`./${query}`);
  await ready(page);
  return page;
}

async function ready(page: Page): Promise<void> {
  await page.evaluate(() => window.sinew.ready);
  await page.evaluate(() => window.sinew.settled());
}

const status = (page: Page) => page.locator('.status');
const keeping = (page: Page) => page.locator('.status .kept');
const names = (page: Page) => page.evaluate(() => window.sinew.characters.map(({ name }) => name));

async function kept(page: Page): Promise<void> {
  await expect(keeping(page)).toHaveAttribute('data-keeping', 'kept');
}

/** Ends the process of a page, so that nothing of it runs any more. */
async function crash(page: Page): Promise<void> {
  const crashed = page.waitForEvent('crash');
  await page.goto('chrome://crash').catch(() => undefined);
  await crashed;
  await page.close();
}

test('a scene comes back after a crash, with its own files, and a fresh start is offered', async ({
  context,
}) => {
  const page = await visit(context);
  await expect(keeping(page), 'the first scene is nobody’s work').toHaveCount(0);
  await drop(page, madeCharacter(5, 2));
  const set = await setPose(page, { joints: { '#1': [0.5, 0, 0] } });
  await kept(page);
  const [before, picture] = [await names(page), await capture(page)];
  await crash(page);

  const back = await visit(context);
  await expect(status(back)).toContainText(/Restored the scene of today/);
  expect(await names(back)).toEqual(before);
  expect(await getPose(back)).toEqual(set);
  expect((await capture(back)).equals(picture), 'the same picture').toBe(true);
  await back.getByRole('button', { name: 'Start fresh' }).click();
  await back.evaluate(() => window.sinew.settled());
  await expect.poll(() => names(back)).toHaveLength(2);
  await expect(back.getByRole('button', { name: 'Start fresh' })).toHaveCount(0);
});
