import { expect, type Page } from '@playwright/test';
import { chooseKernel, openSmallView, setPose, verify } from './support/app.ts';
import { wildPose } from './support/poses.ts';
import { failureTest as test } from './support/test.ts';
import { watchWasmKernel } from './support/wasm-kernel.ts';

const causes = {
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
