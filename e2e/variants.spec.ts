import { expect } from '@playwright/test';
import { capture, drop, openSmallView, openView, setPose, verify } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { test } from './support/test.ts';

// One character by every way to the vertex shader: the pictures are equal to the pixel.
test('palettes and influences from textures give the same pixels', async ({ page }) => {
  const pictures: Buffer[] = [];
  for (const textures of ['', 'palette,influences']) {
    await openView(page, `model=hand&textures=${textures}`);
    expect(await verify(page), textures).toMatchObject({ identical: true });
    pictures.push(await capture(page));
  }
  for (const picture of pictures) expect(picture).toEqual(pictures[0]);
});

test('what the block or the attributes do not hold takes the textures by itself', async ({
  page,
}) => {
  await openSmallView(page, 'model=tube');
  // 1,365 entries fit in the largest block; 16 influences in the attributes.
  for (const [joints, influences] of [
    [1500, 4],
    [40, 24],
    [1500, 24],
  ] as const) {
    await drop(page, madeCharacter(joints, influences));
    await setPose(page, { joints: { '#1': [0.4, 0.2, 0.1], '#7': [0.3, -0.5, 0.2] } });
    expect(await verify(page), `${joints} joints`).toMatchObject({ identical: true });
    const textures = await page.evaluate(() => window.sinew.liveObjects['texture']);
    expect(textures).toBeGreaterThan(3);
  }
});
