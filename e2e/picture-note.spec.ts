import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { PNG } from 'pngjs';
import { insertPngText } from '../src/formats/png/text-chunk.ts';
import { bytesOf, drop, getPose, openApp, setPose } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use({ ...coarse, viewport: { width: 960, height: 420 } });
const page = sharedPage((page) => openApp(page, 'model=tube'));

async function savedPicture(): Promise<Buffer> {
  await page().locator('canvas.scene').focus();
  const [download] = await Promise.all([
    page().waitForEvent('download'),
    page().keyboard.press('j'),
  ]);
  return readFileSync(await download.path());
}

test('a PNG remembers its scene, and dropping it opens that', async () => {
  const pose = await setPose(page(), { joints: { '#2': [0.1, 0.2, 0.3] }, root: [0, 0.5, 0] });
  const png = await savedPicture();
  await page().evaluate(() => window.sinew.open('hand'));
  await drop(page(), [{ name: 'renamed.png', content: png }]);
  await expect(page().locator('.status')).toContainText('tube');
  expect(await page().evaluate(() => window.sinew.pose())).toEqual(pose);
});

test('a PNG of your own files remembers only their name, and poses them again', async () => {
  await drop(page(), madeCharacter(5, 2));
  const pose = await setPose(page(), { joints: { '#1': [0.5, 0, 0] } });
  const png = await savedPicture();
  await page().getByRole('button', { name: 'Reset all' }).click();
  await drop(page(), [{ name: 'again.png', content: png }]);
  expect(await page().evaluate(() => window.sinew.pose())).toEqual(pose);
  await page().evaluate(() => window.sinew.open('tube'));
});

test('a damaged note is reported by line and column, and nothing changes', async () => {
  const picture = new Uint8Array(PNG.sync.write(new PNG({ width: 2, height: 2 })));
  const note = '{"bundled":"hand","name":"Hand","pose":[]}';
  const content = Buffer.from(insertPngText(picture, 'Sinew', note));
  await drop(page(), [{ name: 'damaged.png', content }]);
  await expect(page().locator('.problems')).toContainText('damaged.png:1:40 (pose)');
  await expect(page().locator('.status')).toContainText('tube');
});

test('pictures have the requested size, with or without background', async () => {
  for (const background of [true, false]) {
    const blob = await page().evaluateHandle(
      (background) => window.sinew.capture({ width: 701, height: 333, background }),
      background,
    );
    const { width, height, data } = PNG.sync.read(await bytesOf(blob));
    expect([width, height]).toEqual([701, 333]);
    expect(data[3], 'alpha in the corner').toBe(background ? 255 : 0);
    const opaque = data.filter((value, i) => i % 4 === 3 && value === 255).length;
    expect(opaque / (width * height), 'the character, or all').toBeGreaterThan(0.05);
    if (!background) expect(opaque / (width * height)).toBeLessThan(0.5);
  }
});

test('a picture larger than the GPU can draw is refused with a message', async () => {
  const refused = await page().evaluate(() =>
    window.sinew.capture({ width: 1_000_000, height: 16 }).then(
      () => '',
      (error: unknown) => String(error),
    ),
  );
  expect(refused).toContain('picture of 1,000,000 × 16');
});

test('a PNG of an early version, which remembers a character and its pose, opens both', async () => {
  const picture = new Uint8Array(PNG.sync.write(new PNG({ width: 2, height: 2 })));
  const note = '{"bundled":"tube","name":"Tube","pose":{"joints":{"#2":[0.1,0.2,0.3]}}}';
  await page().evaluate(() => window.sinew.open('hand'));
  await drop(page(), [
    { name: 'early.png', content: Buffer.from(insertPngText(picture, 'Sinew', note)) },
  ]);
  await expect(page().locator('.status')).toContainText('tube');
  expect((await getPose(page())).joints).toEqual({ 'joint 02': [0.1, 0.2, 0.3] });
});
