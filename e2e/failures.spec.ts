import { expect, type Page } from '@playwright/test';
import { convertTargets, labelOf } from '../src/formats/registry.ts';
import { choose, controlRow, openApp, openTab } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, failureTest as test } from './support/test.ts';

test.use({ ...coarse, viewport: { width: 1000, height: 480 } });

const notice = (page: Page) => page.locator('.status .notice');

test('a missing part, a picture that can’t be encoded and a folder that can’t be read end in a message', async ({
  page,
}) => {
  await openApp(page, 'model=tube');

  // These are all formats that can be written, as the registry lists them.
  await page.getByRole('button', { name: 'File', exact: true }).click();
  const targets = page.getByRole('menuitem', { name: 'Save as' });
  await expect(targets).toHaveText(convertTargets.map((id) => `Save as ${labelOf(id)}`));

  await test.step('a deploy removed a part that is loaded on demand', async () => {
    await page.route(/save-as-/, (route) => route.fulfill({ status: 404, body: 'gone' }));
    await targets.first().click();
    await expect(notice(page)).toHaveText(/could not be loaded; reload the page/);
  });

  await test.step('a method does not come: what stands in for it is named, and others open', async () => {
    await page.route(/\/rigid-/, (route) => route.fulfill({ status: 404, body: 'gone' }));
    await openTab(page, 'deform');
    // `choose` would wait for the method.
    await controlRow(page, 'Method').locator('select').selectOption('Rigid parts · rigid');
    await expect(notice(page)).toHaveText(/could not be loaded; reload the page/);
    await expect(page.locator('.status')).toContainText('Linear blend (SSD), in place of Rigid');
    await choose(page, 'Method', 'Linear blend (SSD) · lbs');
    await page.evaluate(() => window.sinew.open('insect'));
    await expect(page.locator('.status strong')).toHaveText(/insect/i);
  });

  await test.step('the browser has no memory for the file of a picture', async () => {
    await page.evaluate(() => {
      HTMLCanvasElement.prototype.toBlob = (back: BlobCallback) => back(null);
    });
    await page.locator('canvas.scene').focus();
    await page.keyboard.press('j');
    await expect(notice(page)).toHaveText(/could not make a file of the picture/);
  });

  await test.step('a folder can’t be read, but the files beside it are', async () => {
    const [{ name, content }] = madeCharacter(5, 2) as [{ name: string; content: string }];
    await page.evaluate(
      ({ name, content }) => {
        const denied = new DOMException('a text of the browser', 'NotReadableError');
        const folder = {
          ...{ isDirectory: true, isFile: false, name: 'locked', fullPath: '/locked' },
          createReader: () => ({
            readEntries: (_: unknown, fail: (error: unknown) => void) => fail(denied),
          }),
        };
        const file = {
          ...{ isDirectory: false, isFile: true, name, fullPath: `/${name}` },
          file: (then: (file: File) => void) => then(new File([content], name)),
        };
        const items = [folder, file].map((entry) => ({ webkitGetAsEntry: () => entry }));
        const event = new DragEvent('drop', { bubbles: true, cancelable: true });
        Object.defineProperty(event, 'dataTransfer', { value: { items, files: [] } });
        document.body.dispatchEvent(event);
      },
      { name, content },
    );
    await expect(page.locator('.status strong')).toHaveText('made');
    await expect(page.locator('.problems')).toContainText('locked');
    await expect(page.locator('.problems')).toContainText('a file or folder that can be read');
  });
});

test('when the panels can’t be loaded, the view says so', async ({ page }) => {
  await page.route(/start-interface-.*\.js/, (route) => route.abort());
  await page.goto('./?model=tube');
  await expect(page.getByRole('alert')).toHaveText(/could not be loaded; reload the page/);
});
