import { expect } from '@playwright/test';
import { capture, openView, verify } from './support/app.ts';
import { test } from './support/test.ts';

// One character passes to the vertex shader in every layout, and the pictures are equal pixel for
// pixel.
test('palettes and influences from textures give the same pixels', async ({ page }) => {
  const pictures: Buffer[] = [];
  for (const textures of ['', 'palette,influences']) {
    await openView(page, `model=hand&textures=${textures}`);
    expect(await verify(page), textures).toMatchObject({ identical: true });
    pictures.push(await capture(page));
  }
  for (const picture of pictures) expect(picture).toEqual(pictures[0]);
});
