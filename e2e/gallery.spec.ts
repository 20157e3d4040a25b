import { expect, type Page } from '@playwright/test';
import { drop, type NamedFile, openApp, openTab } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { catalogue, scenes } from './support/catalogue.ts';
import { cameraOf } from './support/controls.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, sharedPage, test } from './support/test.ts';

// The gallery adds characters beside one another, or in place of a scene that nobody touched.
const size = { width: 1000, height: 600 };
test.use({ ...coarse, viewport: size });
/** The pictures that the page asked for. */
const requested: string[] = [];
const page = sharedPage(async (page) => {
  page.on('request', (request) => {
    if (request.url().includes('/pictures/')) requested.push(request.url());
  });
  await openApp(page, 'model=tube');
});

const gallery = (page: Page) => page.getByRole('dialog', { name: 'Add a character' });
const shelf = (page: Page, name: string) => gallery(page).getByRole('region', { name });
const card = (page: Page, name: string) => gallery(page).getByRole('button', { name, exact: true });
const names = (page: Page) => page.evaluate(() => window.sinew.characters.map(({ name }) => name));

/** Opens the gallery by one press. */
async function openGallery(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Add…' }).click();
  await expect(card(page, 'Human')).toBeVisible();
}

test('pictures are requested when the gallery opens, and the search filters cards', async () => {
  const cards = [...catalogue, ...scenes];
  expect(requested).toEqual([]);
  await openGallery(page());
  await expect.poll(() => requested.length).toBe(cards.length);
  const shown = await gallery(page())
    .locator('img')
    .evaluateAll((images: HTMLImageElement[]) =>
      Promise.all(images.map((image) => image.decode().then(() => image.naturalWidth))),
    );
  expect(shown).toEqual(cards.map(() => 288));

  const search = gallery(page()).getByRole('searchbox', { name: 'Search characters' });
  await search.fill('cse');
  await expect(gallery(page()).locator('.cards button')).toHaveText(['Panda', 'Insect']);
  await search.fill('do');
  await expect(gallery(page()).locator('.cards button')).toHaveText(['Dog', 'A person and a dog']);
  // By keyboard: from the field past the two buttons to the card.
  for (let step = 0; step < 3; step++) await page().keyboard.press('Tab');
  await expect(card(page(), 'Dog')).toBeFocused();
  await page().keyboard.press('Enter');
  await expect.poll(() => names(page())).toEqual(['dog']); // in place of the tube, which nobody touched
});

test('the gallery has no violations in light and dark colors, and fits a phone', async () => {
  await openGallery(page());
  expect(await violations(page(), { within: 'dialog' })).toEqual([]);
  await page().emulateMedia({ colorScheme: 'dark' });
  await expect(gallery(page()).locator('img').first()).toHaveAttribute('src', /-dark\.jpg$/);
  expect(await violations(page(), { within: 'dialog', ...onlyColors })).toEqual([]);
  await page().setViewportSize({ width: 390, height: 700 });
  const box = (await gallery(page()).boundingBox())!;
  expect(box.x).toBeGreaterThanOrEqual(0);
  expect(box.x + box.width).toBeLessThanOrEqual(390);
  for (const each of await gallery(page()).getByRole('button').all()) {
    await each.scrollIntoViewIfNeeded();
    const { x, width } = (await each.boundingBox())!;
    expect(x + width).toBeLessThanOrEqual(box.x + box.width);
  }
  await page().keyboard.press('Escape');
  await page().emulateMedia({ colorScheme: 'light' });
  await openTab(page(), 'pose');
  await page().setViewportSize(size);
});

test('three characters of three courses stand beside one another after six presses', async () => {
  const presses = [
    ['MIT 6.837', 'Human'],
    ['UCSD CSE169', 'Insect'],
    ['UT CS354', 'Mannequin'],
  ] as const;
  for (const [course, name] of presses) {
    await openGallery(page());
    await shelf(page(), course).getByRole('button', { name }).click();
    await expect(gallery(page())).toHaveCount(0);
  }
  await expect.poll(async () => (await names(page())).length).toBe(4);
  expect((await names(page())).slice(0, 3)).toEqual(['dog', 'human', 'insect']);
  await page().evaluate(() => window.sinew.settled());

  for (let step = 0; step < 3; step++) await page().keyboard.press('Control+z');
  expect(await names(page())).toEqual(['dog']);
});

test('presses with Shift keep the gallery open, and each waits for the one before', async () => {
  await openGallery(page());
  for (const name of ['Hand', 'Insect', 'Human']) {
    await card(page(), name).click({ modifiers: ['Shift'] });
  }
  await expect(gallery(page())).toBeVisible();
  await expect.poll(() => names(page())).toEqual(['dog', 'hand', 'insect', 'human']);
  await page().keyboard.press('Escape');
});

test('a scene opens in place of all characters, as one step of undo', async () => {
  const poses = () =>
    page().evaluate(() =>
      window.sinew.characters.map(({ id }) => window.sinew.pose(undefined, id)),
    );
  const before = await names(page());
  await page().evaluate(() => window.sinew.pose({ joints: { '#1': [0.5, 0, 0] } }));
  const posed = await poses();
  await openGallery(page());
  await shelf(page(), 'Scenes').getByRole('button').first().click();
  await expect.poll(() => names(page())).toEqual(['human', 'dog']);
  await page().evaluate(() => window.sinew.settled());
  await expect(page().locator('.notice')).toHaveText('A person and a dog');
  await page().keyboard.press('Control+z');
  expect(await names(page())).toEqual(before);
  expect(await poses()).toEqual(posed);
  await page().keyboard.press('Control+Shift+z');
  expect(await names(page())).toEqual(['human', 'dog']);

  // Who kneels gets up to walk, and the camera steps back for the head, until the user has moved it.
  await page().setViewportSize({ width: 1300, height: 500 });
  await page().locator('.actors .name', { hasText: 'human' }).click();
  await page().keyboard.press('Home');
  const { distance } = await cameraOf(page());
  await page().keyboard.press('p');
  await expect.poll(async () => (await cameraOf(page())).distance).toBeGreaterThan(distance);
  await page().keyboard.press('p');
  await openTab(page(), 'animate');
  await page().getByRole('button', { name: 'Release the clip' }).click();
  await page().keyboard.press('ArrowLeft');
  const turned = await cameraOf(page());
  await page().keyboard.press('p');
  await page().evaluate(() => window.sinew.settled());
  expect(await cameraOf(page())).toEqual(turned);
  await page().keyboard.press('p');
  await page().setViewportSize(size);
});

declare global {
  interface Window {
    /** The handle of each dropped file, by its name. */
    handles: Map<string, FileSystemFileHandle>;
  }
}

/** Gives drops the handles of files in the page's own file system, which browsers keep alike. */
async function giveHandles(page: Page, files: readonly NamedFile[]): Promise<void> {
  const contents = files.map(({ name, content }) => ({ name, text: String(content) }));
  await page.evaluate(async (contents) => {
    window.handles = new Map();
    const folder = await navigator.storage.getDirectory();
    for (const { name, text } of contents) {
      const handle = await folder.getFileHandle(name, { create: true });
      const writable = await handle.createWritable();
      await writable.write(text);
      await writable.close();
      window.handles.set(name, handle);
    }
    Object.assign(DataTransferItem.prototype, {
      getAsFileSystemHandle(this: DataTransferItem) {
        return Promise.resolve(window.handles.get(this.getAsFile()?.name ?? '') ?? null);
      },
    });
  }, contents);
}

test('files of an earlier visit are offered again, by handle or by name', async ({ page }) => {
  const recent = shelf(page, 'Recent').getByRole('button');
  await openApp(page, 'model=tube');
  const [kept, chosen] = ['kept', 'chosen'].map((name) =>
    madeCharacter(3, 1).map((file) => ({ ...file, name: file.name.replace('made', name) })),
  );
  await drop(page, chosen!);
  await giveHandles(page, kept!);
  await drop(page, kept!);
  await expect.poll(() => names(page)).toEqual(['kept']);
  await openGallery(page);
  await expect(shelf(page, 'Your files').getByRole('button')).toHaveText(['chosen', 'kept']);
  await expect(recent).toHaveCount(0);

  await openApp(page, 'model=tube');
  await openGallery(page);
  await expect(recent).toHaveText(['kept', 'chosenchoose it again', 'Forget these']);
  expect(await violations(page, { within: 'dialog' })).toEqual([]);
  await recent.first().click();
  await expect.poll(() => names(page)).toEqual(['kept']);
  expect(await page.evaluate(() => window.sinew.problems)).toEqual([]);

  await openGallery(page);
  const choosing = page.waitForEvent('filechooser');
  await recent.first().click();
  await choosing;
  await openGallery(page);
  await recent.last().click();
  await expect(shelf(page, 'Recent')).toHaveCount(0);
  await openApp(page, 'model=tube');
  await openGallery(page);
  await expect(recent).toHaveCount(0);
});
