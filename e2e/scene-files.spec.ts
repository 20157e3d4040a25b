import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { strToU8, unzipSync, zipSync } from 'fflate';
import { capture, chooseFromMenu, drop, getPose, openApp, setPose } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use({ ...coarse, viewport: { width: 960, height: 420 } });
test.describe.configure({ timeout: 60_000 });

/** The page, in a browser that lets no page write files, so that they are downloaded. */
const page = sharedPage(async (page) => {
  await page.addInitScript(() => {
    if (sessionStorage.getItem('writes') === null) {
      Object.defineProperty(window, 'showSaveFilePicker', { value: undefined });
    }
  });
  await openApp(page, 'model=tube');
});

const names = () => page().evaluate(() => window.sinew.characters.map(({ name }) => name));

async function savedScene(): Promise<Buffer> {
  const [download] = await Promise.all([
    page().waitForEvent('download'),
    page().keyboard.press('ControlOrMeta+s'),
  ]);
  return readFileSync(await download.path());
}

test('a scene file has the scene and its files, and opens the same picture as one step', async () => {
  const files = madeCharacter(5, 2);
  await drop(page(), files);
  await page().evaluate(() => window.sinew.add('insect'));
  await setPose(page(), { joints: { '#3': [0.1, 0, 0] } });
  const [before, pose, picture] = [await names(), await getPose(page()), await capture(page())];
  const scene = await savedScene();
  await expect(page().locator('.status')).toContainText('Scene saved as');
  const entries = unzipSync(scene);
  expect(Object.keys(entries)).toEqual(['scene.json', ...files.map(({ name }) => `files/${name}`)]);
  for (const { name, content } of files) {
    expect(Buffer.from(entries[`files/${name}`]!).equals(Buffer.from(content))).toBe(true);
  }

  await chooseFromMenu(page(), 'New');
  expect(await names()).toEqual([]);
  await expect(page().locator('.status .kept')).toHaveCount(0);
  await page().reload();
  await page().evaluate(() => window.sinew.ready);
  await drop(page(), [{ name: 'two.sinew', content: scene }]);
  await expect(page().locator('.status')).toContainText('two opened');
  expect(await names()).toEqual(before);
  expect(await getPose(page())).toEqual(pose);
  expect((await capture(page())).equals(picture), 'the same picture').toBe(true);
  await page().keyboard.press('ControlOrMeta+z');
  expect(await names()).toEqual(['tube']);
});

test('a scene file of version 0 opens, and one of a newer version says so', async () => {
  const older = '{"bundled":"tube","name":"Tim","pose":{"joints":{"#1":[0.25,0,0]}}}';
  await drop(page(), [sceneFile(older)]);
  expect(await names()).toEqual(['Tim']);
  expect((await getPose(page())).joints).toEqual({ 'joint 01': [0.25, 0, 0] });
  await drop(page(), [sceneFile('{"version":2,"characters":[],"actors":[]}')]);
  await expect(page().locator('.status')).toContainText('a newer Sinew wrote it');
  await expect(page().locator('.problems')).toContainText('scene.sinew:1:12 (version)');
  expect(await names()).toEqual(['Tim']);
});

test('a scene file that is damaged says so, and nothing changes', async () => {
  await drop(page(), [{ name: 'cut.sinew', content: 'no zip' }]);
  await expect(page().locator('.status')).toContainText('The scene could not be opened');
  await expect(page().locator('.problems')).toContainText('cut.sinew');
  await drop(page(), [{ name: 'empty.sinew', content: zipSync({ 'a.txt': strToU8('a') }) }]);
  await expect(page().locator('.problems')).toContainText('scene.json');
  expect(await names()).toEqual(['Tim']);
});

test('where the browser lets the page write files, the next saving overwrites the same one', async () => {
  await page().evaluate(async () => {
    const root = await navigator.storage.getDirectory();
    const handle = await root.getFileHandle('mine.sinew', { create: true });
    const asked: string[] = [];
    Object.assign(window, { asked });
    Object.defineProperty(window, 'showSaveFilePicker', {
      configurable: true,
      value: ({ suggestedName }: { suggestedName: string }) => {
        asked.push(suggestedName);
        return Promise.resolve(handle);
      },
    });
  });
  const size = () =>
    page().evaluate(async () => {
      const root = await navigator.storage.getDirectory();
      return (await (await root.getFileHandle('mine.sinew')).getFile()).size;
    });
  await page().keyboard.press('ControlOrMeta+s');
  await expect(page().locator('.status')).toContainText('Scene saved as mine.sinew');
  const first = await size();
  await setPose(page(), { joints: { '#1': [0.123456789, 0.2, 0.3] } });
  await page().keyboard.press('ControlOrMeta+s');
  await expect.poll(size).toBeGreaterThan(first);
  expect(
    await page().evaluate(() => (window as unknown as { asked: string[] }).asked),
  ).toHaveLength(1);
});

/** A scene file with this text. */
function sceneFile(text: string): { name: string; content: Uint8Array } {
  return { name: 'scene.sinew', content: zipSync({ 'scene.json': strToU8(text) }) };
}
