import { expect } from '@playwright/test';
import { drop, openApp, openTab } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, test } from './support/test.ts';

// A small view is drawn faster, and its size does not matter here.
test.use({ ...coarse, viewport: { width: 960, height: 420 } });

test('a character beyond the limits of the GPU is reported, and the page keeps working', async ({
  page,
}) => {
  await page.addInitScript(() => {
    const { getParameter } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.getParameter = function (name: number): unknown {
      // This simulates a GPU with small textures, which a character with more than 16 influences
      // per vertex does not fit.
      return name === this.MAX_TEXTURE_SIZE ? 1023 : (getParameter.call(this, name) as unknown);
    };
  });
  await openApp(page, 'model=tube');
  // Passes create their objects when they first draw a character.
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
  await page.evaluate(() => window.sinew.capture());
  const { framebuffer, renderbuffer, ...others } = await page.evaluate(
    () => window.sinew.liveObjects,
  );
  expect({ ...objects, ...others }).toEqual(objects);
  // A busy machine may have drawn drafts meanwhile, which have a target of their own.
  expect(framebuffer! - objects['framebuffer']!).toBeLessThanOrEqual(2);
  expect(renderbuffer! - objects['renderbuffer']!).toBeLessThanOrEqual(3);
});

test('without WebGL2 the page says what to do, and its panels work', async ({ page }) => {
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
  await expect(page.locator('.subject')).toContainText('5 joints');
  await page.evaluate(() => window.sinew.pose({ joints: { '#1': [0, 1, 0] } }));
  expect(await page.evaluate(() => window.sinew.vertices('cpu').length)).toBe(180);
  await page.getByRole('button', { name: 'Save pose' }).click();
  await openTab(page, 'deform');
  await page.getByRole('button', { name: 'Compare GPU with CPU' }).click();
  await expect(page.locator('.notice')).toContainText('nothing on the GPU');
});
