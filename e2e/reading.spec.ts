import { expect } from '@playwright/test';
import { zipSync } from 'fflate';
import { drop, openApp } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { test } from './support/test.ts';

const encoder = new TextEncoder();

function packed(count: number): Uint8Array {
  const files: Record<string, Uint8Array> = {};
  for (let i = 0; i < count; i++) {
    for (const { name, content } of madeCharacter(5, 2)) {
      files[`Folder ${i}\\${name.replace('made', `made${i}`)}`] = encoder.encode(content as string);
    }
  }
  files['__MACOSX/Folder 0/._made0.skel'] = encoder.encode('resource fork');
  return zipSync(files);
}

test('each of several characters in an archive is offered', async ({ page }) => {
  await openApp(page, 'model=tube');
  await drop(page, [{ name: 'all.zip', content: packed(3) }]);
  expect(await page.evaluate(() => window.sinew.problems)).toEqual([]);
  for (const name of ['made2', 'made0', 'made1']) {
    await page.locator('.picker').getByRole('button', { name, exact: true }).click();
    await expect(page.locator('.status strong')).toHaveText(name);
  }
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.locator('.status strong')).toHaveText('made0');
});

test('files dropped again after a change keep pose and camera', async ({ page }) => {
  await openApp(page, 'model=tube');
  const files = madeCharacter(5, 2);
  await drop(page, files);
  const pose = await page.evaluate(() =>
    window.sinew.pose({ joints: { '#1': [0.3, 0, 0] }, root: [0, 0.1, 0] }),
  );
  await page.locator('canvas').focus();
  await page.keyboard.press('ArrowLeft');
  const azimuth = await page.getByRole('slider', { name: 'Azimuth' }).getAttribute('aria-valuenow');
  const changed = files.map((file) =>
    file.name.endsWith('.obj') ? { ...file, content: `${file.content as string}v 9 9 9\n` } : file,
  );
  const attach = changed.find(({ name }) => name.endsWith('.attach'))!;
  const rows = (attach.content as string).trimEnd().split('\n');
  const longer = { ...attach, content: [...rows, rows[0]].join('\n') };
  await drop(page, [...changed.filter((file) => file !== attach), longer]);
  expect(await page.evaluate(() => window.sinew.characters[0]!.vertexCount)).toBe(61);
  expect(await page.evaluate(() => window.sinew.pose())).toEqual(pose);
  expect(await page.getByRole('slider', { name: 'Azimuth' }).getAttribute('aria-valuenow')).toBe(
    azimuth,
  );
});

test('what takes a while shows how far it is, and can be stopped', async ({ page }) => {
  // The server is slow to hand out the dog; the page shows so, and lets go of it.
  await page.route('**/dog.obj.gz', async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 1500));
    await route.continue().catch(() => undefined);
  });
  await openApp(page, 'model=tube');
  await page.getByRole('button', { name: 'Dog' }).click();
  await expect(page.locator('.progress')).toContainText('Loading Dog');
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect(page.locator('.progress')).toBeHidden();
  await page.waitForTimeout(1800);
  await expect(page.locator('.status strong')).toHaveText('tube');
});

test('a newer drop ends the one under way', async ({ page }) => {
  await openApp(page, 'model=tube');
  const large = madeCharacter(400, 4).map((file) =>
    file.name.endsWith('.obj')
      ? { ...file, content: `${file.content as string}${'# filler\n'.repeat(200_000)}` }
      : { ...file },
  );
  await page.evaluate(() => ((window as { opened?: string[] }).opened = []));
  const first = drop(page, large).catch(() => undefined);
  await drop(page, madeCharacter(5, 2));
  await first;
  await page.waitForTimeout(1000);
  expect(await page.evaluate(() => window.sinew.characters[0]!.joints.length)).toBe(5);
});
