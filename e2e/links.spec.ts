import { expect, type Page } from '@playwright/test';
import { capture, drop, getPose, setPose } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, test } from './support/test.ts';

test.use({
  ...coarse,
  viewport: { width: 760, height: 360 },
  permissions: ['clipboard-read', 'clipboard-write'],
});

async function visit(page: Page, address = ''): Promise<void> {
  await page.goto(`./?test${address}`);
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

test('a link opens the same picture on a fresh page, by the byte, and on an open one as one step of undo', async ({
  page,
  browser,
}) => {
  await visit(page);
  await page.evaluate(() => window.sinew.add('insect'));
  await setPose(page, { joints: { '#3': [0.1, 0.2, 0.3] } });
  await page.evaluate(() => window.sinew.seek(0.37));
  await page.locator('canvas.scene').focus();
  for (const key of ['ArrowLeft', 'ArrowUp', 's', 'a']) await page.keyboard.press(key);
  const picture = await capture(page);
  const hash = await copyLink(page);
  const poses = await page.evaluate(() =>
    window.sinew.characters.map(({ id }) => window.sinew.pose(undefined, id)),
  );

  const fresh = await (await browser.newContext()).newPage();
  await visit(fresh, hash);
  expect(await names(fresh)).toEqual(await names(page));
  expect(
    await fresh.evaluate(() =>
      window.sinew.characters.map(({ id }) => window.sinew.pose(undefined, id)),
    ),
  ).toEqual(poses);
  expect((await capture(fresh)).equals(picture), 'the same picture').toBe(true);
  const linked = await names(fresh);
  await fresh.context().close();

  await page.evaluate(() => window.sinew.open('tube'));
  const before = await names(page);
  await page.evaluate((hash) => void (location.hash = hash), hash);
  await expect.poll(() => names(page)).toEqual(linked);
  await page.keyboard.press('ControlOrMeta+z');
  await expect.poll(() => names(page)).toEqual(before);
});

test('a link that is cut, no scene or newer is a message, and the first scene opens', async ({
  page,
}) => {
  const says = (message: string): Promise<void> =>
    expect(status(page)).toContainText(`The link could not be opened: ${message}`);
  await visit(page, '#s=1.rVI9T8Mw');
  await says('it is damaged');
  await expect.poll(() => names(page)).toHaveLength(2);
  for (const [hash, message] of [
    ['#s=9.abc', 'a newer Sinew made it'],
    ['#s=1.q1YqAQA', 'it is damaged'],
  ] as const) {
    await page.evaluate((hash) => void (location.hash = hash), hash);
    await says(message);
    expect(await names(page)).toHaveLength(2);
  }
});

test('a link asks for your own files, which it only names', async ({ page, browser }) => {
  await visit(page, '&model=tube');
  const files = madeCharacter(5, 2);
  await drop(page, files);
  const pose = await setPose(page, { joints: { '#1': [0.5, 0, 0] } });
  const hash = await copyLink(page);
  await expect(status(page)).toContainText('is asked for the files');

  const fresh = await (await browser.newContext()).newPage();
  await visit(fresh, hash);
  const dialog = fresh.getByRole('dialog', { name: 'Files of the scene' });
  for (const { name } of files) await expect(dialog).toContainText(name);
  await drop(
    fresh,
    files.map(({ name, content }) => ({ name: `renamed ${name}`, content })),
  );
  await expect(dialog).toHaveCount(0);
  expect(await getPose(fresh)).toEqual(pose);
  expect(await fresh.evaluate(() => window.sinew.problems)).toEqual([]);
  await fresh.context().close();
});
