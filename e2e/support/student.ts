import { readFileSync } from 'node:fs';
import { expect, type Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { capture, getPose, type NamedFile } from './app.ts';
import { countedUser } from './counted-user.ts';

/** A quarter of a turn, as a student types it. */
const angle = 1.57;

export async function expectElbowTurned(page: Page): Promise<void> {
  expect((await getPose(page)).joints).toEqual({ 'Right elbow': [0, 0, angle] });
}

/**
 * Drops a character of the course on the first visit, turns its right elbow about z, and saves the
 * picture. Returns the count of presses.
 */
export async function doStudentsJob(page: Page, files: readonly NamedFile[]): Promise<number> {
  const user = countedUser(page);
  const { x, y, width, height } = (await page.locator('canvas.scene').boundingBox())!;
  await user.drop(files, { x: x + width / 2, y: y + height / 2 });
  await user.click(page.getByRole('treeitem', { name: 'Right elbow' }));
  const straight = await capture(page);
  await user.type(page.getByRole('textbox', { name: 'Right elbow Z' }), String(angle));
  await expectElbowTurned(page);
  expect(await page.evaluate(() => window.sinew.characters.length), 'it replaced the scene').toBe(
    1,
  );

  const download = page.waitForEvent('download');
  await user.click(page.getByRole('button', { name: 'Save a picture' }));
  const saved = pixels(readFileSync(await (await download).path()));
  expect(saved.equals(pixels(await capture(page))), 'the picture that is shown').toBe(true);
  expect(saved.equals(pixels(straight))).toBe(false);
  return user.presses;
}

/** A saved picture has a note in its file as well, so only pixels can be compared. */
function pixels(file: Buffer): Buffer {
  return PNG.sync.read(file).data;
}
