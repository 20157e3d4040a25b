import { expect, type Page, test as base } from '@playwright/test';
import { chooseKernel, openSmallView, setPose, verify } from './support/app.ts';
import { wildPose } from './support/poses.ts';
import { watchWasmKernel } from './support/wasm-kernel.ts';

// The browser logs what it could not load, so these tests check everything that support/test.ts
// checks except the console.
const test = base.extend({
  page: async ({ page }, use) => {
    const thrown: string[] = [];
    page.on('pageerror', (error) => thrown.push(error.stack ?? error.message));
    await use(page);
    expect(thrown).toEqual([]);
  },
});

const causes = {
  'is missing on the server': (page) =>
    page.route('**/*.wasm', (route) => route.fulfill({ status: 404, body: 'gone' })),
  'is not what it should be': (page) =>
    page.route('**/*.wasm', (route) => route.fulfill({ body: '<!doctype html>' })),
  'can’t run in this browser': (page) =>
    page.addInitScript(() => Reflect.deleteProperty(window, 'WebAssembly')),
} satisfies Record<string, (page: Page) => Promise<unknown>>;

for (const [cause, prepare] of Object.entries(causes)) {
  test(`the strict kernel goes on where the WebAssembly kernel ${cause}`, async ({ page }) => {
    await watchWasmKernel(page);
    await prepare(page);
    await openSmallView(page, 'model=tube');
    await page.waitForLoadState('networkidle');
    await setPose(page, wildPose(3, 1));
    await chooseKernel(page, 'rigid');
    expect(await verify(page)).toMatchObject({ identical: true, position: 0, normal: 0 });
    expect(await page.evaluate(() => window.wasmSkins)).toBe(0);
  });
}
