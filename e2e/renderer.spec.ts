import { expect, test } from '@playwright/test';

// Every picture and every number of this suite comes from one renderer, which gives the same result
// on every machine. Without it, or without WebGL2, the other tests would prove nothing.
test('the page draws with SwiftShader', async ({ page }) => {
  await page.goto('about:blank');
  const renderer = await page.evaluate(() => {
    const context = document.createElement('canvas').getContext('webgl2');
    const names = context?.getExtension('WEBGL_debug_renderer_info');
    return names ? String(context?.getParameter(names.UNMASKED_RENDERER_WEBGL)) : 'no WebGL2';
  });
  expect(renderer).toContain('SwiftShader');
});
