import { expect, type Page } from '@playwright/test';
import { PNG } from 'pngjs';
import type { CaptureOptions } from '../src/app/scripting.ts';
import { colorDifference, type Lab, labOf } from '../src/core/color-difference.ts';
import { bytesOf } from './support/app.ts';
import { coarse, openBundled, test } from './support/test.ts';

test.use(coarse);

// A character must stand out from the floor, and the floor must not draw the eye.
const leastDifference = 20; // CIEDE2000
const mostContrast = 6; // of lightness, between the floor's checks

test('the person stands out from a quiet floor, in light and dark colors', async ({ page }) => {
  await openBundled(page, 'whole');
  await page.goto('./');
  await page.evaluate(() => window.sinew.ready);
  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    const { data, width, height } = await captured(page, {});
    const everybody = await captured(page, { background: false });
    await page.getByRole('button', { name: 'Hide dog' }).click();
    const person = await captured(page, { background: false });
    await page.getByRole('button', { name: 'Show dog' }).click();

    const clay: Lab[] = [];
    const floor: Lab[] = [];
    const firstRow = Math.floor(0.82 * height); // in front of everybody, and of their shadows
    for (let pixel = 0; pixel < width * height; pixel++) {
      const at = 4 * pixel;
      const color = labOf([data[at]!, data[at + 1]!, data[at + 2]!]);
      if (person.data[at + 3] === 255) clay.push(color);
      else if (pixel >= firstRow * width && everybody.data[at + 3] === 0) floor.push(color);
    }
    expect(clay.length, 'pixels of the person').toBeGreaterThan(3000);
    expect(floor.length, 'pixels of the floor').toBeGreaterThan(30_000);

    const difference = colorDifference(atRank(clay, 0.5), atRank(floor, 0.5));
    expect(difference, colorScheme).toBeGreaterThanOrEqual(leastDifference);
    const contrast = atRank(floor, 0.95)[0] - atRank(floor, 0.05)[0];
    expect(contrast, colorScheme).toBeLessThanOrEqual(mostContrast);
    expect(contrast, 'there are checks').toBeGreaterThan(0.5);
    const description = `ΔE ${difference.toFixed(1)}, ΔL* ${contrast.toFixed(1)}`;
    test.info().annotations.push({ type: colorScheme, description });
  }
});

async function captured(page: Page, options: CaptureOptions): Promise<PNG> {
  const blob = await page.evaluateHandle(async (options) => {
    await window.sinew.settled();
    return window.sinew.capture({ ...options, width: 640, height: 480 });
  }, options);
  return PNG.sync.read(await bytesOf(blob));
}

/** Each coordinate of the colors at a rank from 0, the least, to 1. */
function atRank(colors: readonly Lab[], rank: number): Lab {
  const index = Math.round(rank * (colors.length - 1));
  return [0, 1, 2].map(
    (axis) => colors.map((color) => color[axis]!).sort((a, b) => a - b)[index]!,
  ) as unknown as Lab;
}
