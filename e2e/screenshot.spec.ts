import { readFileSync } from 'node:fs';
import { expect, type Download, type Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { bytesOf, capture, choose, controlRow, openApp } from './support/app.ts';
import { drawPlainly, openBundled, sharedPage, test } from './support/test.ts';

// The view is small because its pixels are compared one by one.
test.use({ viewport: { width: 1000, height: 480 } });

// The test gets the view's pixels independently of the saved file: from the browser's own
// screenshot of the page, cropped to the canvas. Every byte must be the same.
test.describe('the view between its panels', () => {
  const page = sharedPage(async (page) => {
    await drawPlainly(page);
    await openBundled(page, 'small');
    await openApp(page);
  });

  test('is saved with "j" pixel for pixel', () => expectSaved(page()));

  test('is captured by scripts pixel for pixel, as PNG and as JPEG', async () => {
    const png = PNG.sync.read(await capture(page()));
    expectPixels(png, await shownPixels(page()));
    await expectJpeg(page(), await capture(page(), 'jpeg'), png);
  });

  test('is saved by the button in the chosen format', async () => {
    await page().locator('.lil-title').getByText('Picture', { exact: true }).click();
    const save = controlRow(page(), 'Save (j)').locator('button');
    const png = await decode(await downloadBy(page(), () => save.click()));
    expectPixels(png, await shownPixels(page()));
    await choose(page(), 'Format', 'JPEG');
    const jpeg = await downloadBy(page(), () => save.click());
    expect(jpeg.suggestedFilename()).toBe('human.jpg');
    await expectJpeg(page(), readFileSync(await jpeg.path()), png);
  });
});

async function expectSaved(page: Page): Promise<void> {
  // This differs from the view of a first visit, so that a picture from another moment would not
  // match.
  for (const key of ['s', 's', 'ArrowLeft', 'ArrowUp']) await page.keyboard.press(key);
  const saved = await downloadBy(page, () => page.keyboard.press('j'));
  expect(saved.suggestedFilename()).toBe('human.png');
  expectPixels(await decode(saved), await shownPixels(page));
}

async function downloadBy(page: Page, act: () => Promise<void>): Promise<Download> {
  const [download] = await Promise.all([page.waitForEvent('download'), act()]);
  return download;
}

async function decode(download: Download): Promise<PNG> {
  return PNG.sync.read(readFileSync(await download.path()));
}

/** Returns the pixels that the browser shows in place of the canvas. */
async function shownPixels(page: Page): Promise<PNG> {
  await page.evaluate(() => window.sinew.settled());
  // What lies over the picture is no part of it.
  const overlay = page.locator('.overlay, .splitter');
  await overlay.evaluateAll((parts: HTMLElement[]) => {
    for (const part of parts) part.style.visibility = 'hidden';
  });
  const canvas = page.locator('canvas.scene');
  const box = (await canvas.boundingBox())!;
  const shown = PNG.sync.read(await page.screenshot({ clip: box, scale: 'device' }));
  expect(shown).toMatchObject({ width: box.width, height: box.height });
  return shown;
}

function expectPixels(saved: PNG, shown: PNG): void {
  const { width, height } = shown;
  expect({ width: saved.width, height: saved.height }).toEqual({ width, height });
  const differing = saved.data.reduce((sum, byte, i) => sum + Number(byte !== shown.data[i]), 0);
  expect(differing, 'bytes that differ').toBe(0);
  expect(new Set(saved.data).size, 'values of bytes, since both may be empty').toBeGreaterThan(50);
}

/** Expects the same picture except for the losses of JPEG. The browser decodes it. */
async function expectJpeg(page: Page, bytes: Buffer, png: PNG): Promise<void> {
  expect(bytes.subarray(0, 3).toString('hex')).toBe('ffd8ff');
  const decoded = await decodeJpeg(page, bytes);
  expect(decoded).toMatchObject({ width: png.width, height: png.height });
  const sum = png.data.reduce((total, byte, i) => total + Math.abs(byte - decoded.data[i]!), 0);
  expect(sum / png.data.length, 'mean difference of a byte').toBeLessThan(2);
}

async function decodeJpeg(page: Page, bytes: Buffer) {
  const picture = await page.evaluateHandle(async (base64) => {
    const file = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([file], { type: 'image/jpeg' }));
    const { width, height } = bitmap;
    const context = new OffscreenCanvas(width, height).getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    return { width, height, blob: new Blob([data]) };
  }, bytes.toString('base64'));
  const size = await picture.evaluate(({ width, height }) => ({ width, height }));
  return { ...size, data: await bytesOf(await picture.evaluateHandle(({ blob }) => blob)) };
}
