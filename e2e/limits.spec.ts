import { expect } from '@playwright/test';
import { drop, openApp } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { test } from './support/test.ts';

// A small view is drawn sooner; nothing here is about its size.
test.use({ viewport: { width: 760, height: 420 } });

test('a character past the limits of the GPU is told, and the page lives on', async ({ page }) => {
  await page.addInitScript(() => {
    const { getParameter } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.getParameter = function (name: number): unknown {
      // A GPU with small textures: what has more than 16 influences a vertex does not fit.
      return name === this.MAX_TEXTURE_SIZE ? 1023 : (getParameter.call(this, name) as unknown);
    };
  });
  await openApp(page, 'model=tube');
  // The passes that come after the first picture make their objects when they are first drawn.
  await page.evaluate(() => window.sinew.capture());
  const objects = await page.evaluate(() => window.sinew.liveObjects);
  await drop(page, madeCharacter(30, 20));
  await expect(page.locator('.message')).toContainText("can't be drawn here");
  expect(await page.evaluate(() => window.sinew.vertices('cpu').length)).toBe(180);
  expect(await page.evaluate(() => window.sinew.verify())).toBeNull();
  await page.evaluate(() => window.sinew.pose({ joints: { '#1': [1, 0, 0] } }));
  await page.evaluate(() => window.sinew.open('tube'));
  await expect(page.locator('.message')).toBeHidden();
  expect(await page.evaluate(() => window.sinew.verify())).toMatchObject({ identical: true });
  expect(await page.evaluate(() => window.sinew.liveObjects)).toEqual(objects);
});

test('without WebGL2 the page says what to do, and its panels are alive', async ({ page }) => {
  await page.addInitScript(() => {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      ...parameters: Parameters<typeof getContext>
    ) {
      return parameters[0] === 'webgl2' ? null : getContext.apply(this, parameters);
    } as typeof getContext;
  });
  await page.goto('./');
  await expect(page.locator('.message')).toContainText('WebGL2');
  await drop(page, madeCharacter(5, 2));
  await expect(page.locator('.status')).toContainText('5 joints');
  await page.evaluate(() => window.sinew.pose({ joints: { '#1': [0, 1, 0] } }));
  expect(await page.evaluate(() => window.sinew.vertices('cpu').length)).toBe(180);
  await page.getByRole('button', { name: 'Save pose' }).click();
  await page.getByRole('button', { name: 'Verify' }).click();
  await expect(page.locator('.notice')).toContainText('nothing on the GPU');
});
