import { expect, type BrowserContext, type Page } from '@playwright/test';
import { capture, drop, getPose, setPose } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, failureTest, test } from './support/test.ts';

test.use({ ...coarse, viewport: { width: 760, height: 360 } });

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

test('two tabs keep a scene each, a reload brings back its own, and an address with a name wins', async ({
  context,
}) => {
  const first = await visit(context);
  await first.evaluate(() => window.sinew.open('tube'));
  await setPose(first, { joints: { '#1': [0.1, 0, 0] } });
  await kept(first);
  const second = await visit(context);
  expect(await names(second), 'the scene of an open tab is not opened twice').toHaveLength(2);
  await second.evaluate(() => window.sinew.open('insect'));
  await kept(second);
  await setPose(first, { joints: { '#1': [0.2, 0, 0] } });
  await kept(first);

  const own = await names(first);
  expect(own).not.toEqual(await names(second));
  await first.reload();
  await ready(first);
  expect(await names(first)).toEqual(own);
  expect((await getPose(first)).joints).toEqual({ 'joint 01': [0.2, 0, 0] });

  await first.goto('./?model=hand');
  await ready(first);
  expect(await names(first)).toEqual(['hand']);
  await first.getByRole('button', { name: 'Add…' }).click();
  const earlier = first.getByRole('region', { name: 'Earlier scenes' });
  await earlier.getByRole('button').first().click();
  await expect.poll(() => names(first)).toEqual(expect.arrayContaining(['tube']));
  expect((await getPose(first)).joints).toEqual({ 'joint 01': [0.2, 0, 0] });
});

/** Replaces a part of the text of the kept scene, which is as if it had never been refused. */
async function change(page: Page, from: string, to: string): Promise<void> {
  await page.evaluate(
    async ([from, to]) => {
      const opening = indexedDB.open('sinew');
      const database = await new Promise<IDBDatabase>((resolve, reject) => {
        opening.onsuccess = () => resolve(opening.result);
        opening.onerror = () => reject(new Error('no database'));
      });
      const store = database.transaction('scenes', 'readwrite').objectStore('scenes');
      const all = store.getAll();
      await new Promise((resolve) => (all.onsuccess = resolve));
      const [record] = all.result as { text: string }[];
      const text = record!.text.replace(from, to);
      const put = store.put({ ...record, text, isRefused: false });
      await new Promise((resolve) => (put.onsuccess = resolve));
      database.close();
    },
    [from, to] as const,
  );
}

test('a kept scene that is damaged, or of a newer Sinew, is a message, and the first scene opens', async ({
  context,
}) => {
  const page = await visit(context, '?model=hand');
  await page.evaluate(() => window.sinew.open('tube'));
  await kept(page);
  await change(page, '"version":1', '"version":99');
  await page.close();
  const next = await visit(context);
  await expect(status(next)).toContainText('could not be restored: a newer Sinew wrote it');
  expect(await names(next)).toHaveLength(2);
  await change(next, '"actors"', '"act');
  await next.reload();
  await ready(next);
  await expect(status(next)).toContainText('could not be restored: it is damaged');
  expect(await names(next)).toHaveLength(2);
  await next.reload();
  await ready(next);
  await expect(status(next), 'it is not tried again').not.toContainText('could not be restored');
});

failureTest(
  'a browser without room, or that keeps nothing, says so; the page goes on',
  async ({ page }) => {
    await page.addInitScript(() => {
      const { put } = IDBObjectStore.prototype;
      IDBObjectStore.prototype.put = function (...values) {
        if (sessionStorage.getItem('full') === null) return put.apply(this, values);
        throw new DOMException('no room', 'QuotaExceededError');
      };
      if (sessionStorage.getItem('private') !== null) {
        Object.defineProperty(window, 'indexedDB', { value: undefined });
      }
    });
    await page.goto('./?model=tube');
    await ready(page);
    await page.evaluate(() => sessionStorage.setItem('full', ''));
    const set = await setPose(page, { joints: { '#1': [0.1, 0, 0] } });
    await expect(status(page)).toContainText('no room to keep the scene');
    await expect(keeping(page)).toHaveText('Not saved');
    expect(await getPose(page)).toEqual(set);
    await page.evaluate(() => sessionStorage.removeItem('full'));
    const more = await setPose(page, { joints: { '#1': [0.2, 0, 0] } });
    await kept(page);
    expect(await getPose(page)).toEqual(more);

    await page.evaluate(() => sessionStorage.setItem('private', ''));
    await page.goto('./?model=hand');
    await ready(page);
    await setPose(page, { joints: { '#1': [0.1, 0, 0] } });
    await expect(status(page)).toContainText('does not keep the scene');
    await expect(keeping(page)).toHaveText('Not saved');
  },
);
