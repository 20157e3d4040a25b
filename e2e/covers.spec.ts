import { readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';
import { expect } from '@playwright/test';
import { PNG } from 'pngjs';
import { capture, choose, drop, openSmallView, setPose } from './support/app.ts';
import { hardPose } from './support/poses.ts';
import { expectPicture } from './support/pictures.ts';
import { sharedPage, test } from './support/test.ts';

const page = sharedPage((page) => openSmallView(page, 'model=insect'));

/** The size of expected pictures; the view itself is smaller. */
const size = { width: 640, height: 480 };

const notice = () => page().locator('output.notice');
const note = () => page().locator('[data-section="surface"] .note');
const undo = () => page().locator('[data-command="undo"]').first().dispatchEvent('click');

/** An F that leans on nothing: it tells left from right and up from down. */
function letter(): Uint8Array {
  const rows = ['......', '.####.', '.#....', '.###..', '.#....', '.#....', '.#....', '......'];
  const scale = 16;
  const png = new PNG({ width: rows[0]!.length * scale, height: rows.length * scale });
  for (let y = 0; y < png.height; y++) {
    for (let x = 0; x < png.width; x++) {
      const isInk = rows[Math.floor(y / scale)]![Math.floor(x / scale)] === '#';
      png.data.set(isInk ? [30, 60, 140, 255] : [240, 220, 130, 255], (y * png.width + x) * 4);
    }
  }
  return PNG.sync.write(png);
}

/** The bundled person without texture coordinates, as the files of 6.837 are. */
function bareHuman() {
  return ['skel', 'obj', 'attach'].map((extension) => {
    const bytes = readFileSync(`public/data/human/human.${extension}.gz`);
    const text = gunzipSync(bytes).toString();
    const content = text.replace(/^vt .*\n/gm, '').replace(/(?<=^f .*)\/\d+/gm, '');
    return { name: `bare.${extension}`, content };
  });
}

test('an image that is dropped covers the character, and Undo takes it off', async () => {
  const before = await capture(page());
  await drop(page(), [{ name: 'letter.png', content: letter() }]);
  await expect(notice()).toHaveText('letter.png covers insect; Undo takes it off');
  const covered = await capture(page());
  expect(Buffer.compare(covered, before)).not.toBe(0);
  expect(await page().evaluate(() => window.sinew.problems)).toEqual([]);
  await undo();
  await expect(notice()).toContainText('Texture letter.png');
  expect(Buffer.compare(await capture(page()), before)).toBe(0);
});

test('an image that can’t be decoded is a problem, and nothing changes', async () => {
  const before = await capture(page());
  const content = letter().slice(0, 40);
  await drop(page(), [{ name: 'cut.png', content }]);
  expect(await page().evaluate(() => window.sinew.problems)).toMatchObject([
    { code: 'image/unknown', file: 'cut.png' },
  ]);
  await drop(page(), [
    { name: 'one.png', content: letter() },
    { name: 'two.webp', content: letter() },
  ]);
  expect(await page().evaluate(() => window.sinew.problems)).toMatchObject([
    { code: 'file/unknown', file: 'two.webp', found: 'another image' },
  ]);
  await expect(notice()).toContainText('one.png covers insect');
  await undo();
  expect(Buffer.compare(await capture(page()), before)).toBe(0);
});

test('texture coordinates are shown as colors, and by a checker', async () => {
  await choose(page(), 'Surface', 'UV colors');
  await expect(note()).toHaveText(/Red is u/);
  expectPicture('insect-uv', await capture(page(), 'png', size));
  await choose(page(), 'Surface', 'Checker');
  await expect(note()).toHaveText('One check is 0.05 of the texture coordinates wide.');
});

test('without texture coordinates a checker lies on a box, and an image around a cylinder', async () => {
  await drop(page(), bareHuman());
  await setPose(page(), hardPose);
  await page().locator('canvas.scene').focus();
  await page().keyboard.press('Home');
  await choose(page(), 'Surface', 'Checker');
  await expect(note()).toHaveText(/no texture coordinates.* One check is [\d.]+ model units wide/);
  expectPicture('human-checker', await capture(page(), 'png', size));
  await choose(page(), 'Surface', 'UV colors');
  await expect(note()).toHaveText('This mesh has no texture coordinates to show.');

  await drop(page(), [{ name: 'letter.png', content: letter() }]);
  await choose(page(), 'Laid on', 'Around a cylinder');
  await page().evaluate(() => {
    const field = document.querySelector<HTMLInputElement>('input[aria-label="Image Repeats"]')!;
    field.value = '4';
    field.dispatchEvent(new Event('input', { bubbles: true }));
    field.dispatchEvent(new Event('blur'));
  });
  await page().evaluate(() => window.sinew.pose({}));
  await page().locator('canvas.scene').focus();
  await page().keyboard.press('Home');
  expectPicture('human-image', await capture(page(), 'png', size));
});

test('normals are drawn as lines, of the faces where the skin is faceted', async () => {
  await choose(page(), 'Surface', 'Clay');
  await choose(page(), 'Normals', 'mean of faces by angle');
  await page().evaluate(() => {
    const rows = [...document.querySelectorAll('.lil-controller')];
    rows
      .find((row) => row.textContent === 'Normals as lines')!
      .querySelector('input')!
      .click();
  });
  expectPicture('human-normals', await capture(page(), 'png', size));
  const smooth = await capture(page());
  await choose(page(), 'Shading', 'Faceted');
  expect(Buffer.compare(await capture(page()), smooth)).not.toBe(0);
});
