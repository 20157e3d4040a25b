import { readFileSync, writeFileSync } from 'node:fs';
import { extname } from 'node:path';
import { chromium } from '@playwright/test';
import { findBrowser } from '../browser.mjs';

/**
 * Writes an image as a smaller JPEG, by a browser, which has decoder, encoder and filter. Another
 * version of it may write other bytes.
 *
 * @param side of the square picture, in pixels
 * @param quality from 0 to 1
 */
export async function shrinkImage(
  from: string,
  to: string,
  { side, quality }: { readonly side: number; readonly quality: number },
): Promise<void> {
  const { path } = findBrowser();
  const browser = await chromium.launch({
    ...(path === undefined ? {} : { executablePath: path }),
    chromiumSandbox: false,
  });
  try {
    const page = await browser.newPage();
    const source = `data:image/${extname(from).slice(1)};base64,${readFileSync(from, 'base64')}`;
    const jpeg = await page.evaluate<string>(encoding(source, side, quality));
    const bytes = Buffer.from(jpeg.slice(jpeg.indexOf(',') + 1), 'base64');
    writeFileSync(to, bytes);
    console.log(`${to.slice(to.lastIndexOf('/') + 1)}: ${bytes.length} bytes`);
  } finally {
    await browser.close();
  }
}

/** A script for the page, as text, because the code around it knows no page. */
function encoding(source: string, side: number, quality: number): string {
  return `(async () => {
    const image = new Image();
    image.src = ${JSON.stringify(source)};
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = ${side};
    const context = canvas.getContext('2d');
    context.imageSmoothingQuality = 'high';
    context.drawImage(image, 0, 0, ${side}, ${side});
    return canvas.toDataURL('image/jpeg', ${quality});
  })()`;
}
