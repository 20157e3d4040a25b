import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { expect } from '@playwright/test';
import { zipSync } from 'fflate';
import { drop, openApp } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, sharedPage, test } from './support/test.ts';

// A small view is drawn faster, and its size does not matter here.
test.use({ ...coarse, viewport: { width: 960, height: 420 } });

const page = sharedPage((page) => openApp(page, 'model=tube'));
const status = () => page().locator('.status strong');

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

test('the characters of an archive are added to the scene in one step of undo', async () => {
  await drop(page(), [{ name: 'all.zip', content: packed(3) }]);
  expect(await page().evaluate(() => window.sinew.problems)).toEqual([]);
  await expect(status()).toHaveText('made0');
  for (const name of ['made2', 'made0', 'made1']) {
    await page().locator('.actors').getByRole('button', { name, exact: true }).click();
    await expect(status()).toHaveText(name);
  }
  await page().getByRole('button', { name: 'Undo' }).click();
  await expect(status()).toHaveText('tube');
  expect(await page().evaluate(() => window.sinew.characters.length)).toBe(1);
});

test('dropping changed files again keeps pose and camera', async () => {
  const files = madeCharacter(5, 2);
  await drop(page(), files);
  const pose = await page().evaluate(() =>
    window.sinew.pose({ joints: { '#1': [0.3, 0, 0] }, root: [0, 0.1, 0] }),
  );
  await page().locator('canvas.scene').focus();
  await page().keyboard.press('ArrowLeft');
  const azimuth = await page()
    .getByRole('slider', { name: 'Azimuth' })
    .getAttribute('aria-valuenow');
  const changed = files.map((file) =>
    file.name.endsWith('.obj') ? { ...file, content: `${file.content as string}v 9 9 9\n` } : file,
  );
  const attach = changed.find(({ name }) => name.endsWith('.attach'))!;
  const rows = (attach.content as string).trimEnd().split('\n');
  const longer = { ...attach, content: [...rows, rows[0]].join('\n') };
  await drop(page(), [...changed.filter((file) => file !== attach), longer]);
  expect(await page().evaluate(() => window.sinew.characters[0]!.vertexCount)).toBe(61);
  expect(await page().evaluate(() => window.sinew.pose())).toEqual(pose);
  expect(await page().getByRole('slider', { name: 'Azimuth' }).getAttribute('aria-valuenow')).toBe(
    azimuth,
  );
});

test('a slow opening shows its progress and can be stopped', async () => {
  // The server delays the dog; the page shows the progress and cancels.
  let handOut = (): void => undefined;
  const slowly = new Promise<void>((resolve) => (handOut = resolve));
  await page().route('**/dog.obj.gz', async (route) => {
    await slowly;
    await route.continue().catch(() => undefined); // the page may have canceled the request
  });
  await page().evaluate(() => void (window.bundled = 'whole'));
  const before = await status().textContent();
  const opening = page().evaluate(() => window.sinew.open('dog'));
  await expect(page().locator('.progress')).toContainText('Loading Dog');
  await page().getByRole('button', { name: 'Cancel' }).click();
  await expect(page().locator('.progress')).toBeHidden();
  handOut();
  await opening;
  await page().waitForTimeout(300);
  await expect(status()).toHaveText(before!);
});

test('a newer drop cancels the one in progress', async () => {
  const large = madeCharacter(400, 4).map((file) =>
    file.name.endsWith('.obj')
      ? { ...file, content: `${file.content as string}${'# filler\n'.repeat(200_000)}` }
      : { ...file },
  );
  await page().evaluate(() => window.sinew.open('tube'));
  const first = drop(page(), large).catch(() => undefined);
  await drop(page(), madeCharacter(5, 2));
  await first;
  await page().waitForTimeout(500);
  expect(await page().evaluate(() => window.sinew.characters[0]!.joints.length)).toBe(5);
});

// Sinew once tested the entries of a drop with `instanceof`, for classes that browsers do not
// expose.
test('a dropped folder is read with all its content except junk files', async () => {
  const folder = test.info().outputPath('Mödels');
  mkdirSync(path.join(folder, 'inner'), { recursive: true });
  for (const { name, content } of madeCharacter(5, 2)) {
    writeFileSync(path.join(folder, 'inner', name.replace('made', 'inside')), content);
    writeFileSync(path.join(folder, 'inner', `._${name}`), 'resource fork');
  }
  const client = await page().context().newCDPSession(page());
  const data = { items: [], files: [folder], dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop'] as const) {
    await client.send('Input.dispatchDragEvent', { type, x: 400, y: 200, data });
  }
  await expect(status()).toHaveText('inside');
  expect(await page().evaluate(() => window.sinew.problems)).toEqual([]);
});

test('a reader that can’t be loaded ends in a message, and the page stays as it was', async () => {
  // This is what happens after a deploy removed the script.
  const before = await status().textContent();
  await page().evaluate(() => {
    window.Worker = class extends EventTarget {
      postMessage(): void {
        setTimeout(() => this.dispatchEvent(new Event('error')));
      }
      terminate(): void {
        // This worker never runs.
      }
    } as unknown as typeof Worker;
  });
  const [skel, obj, attach] = madeCharacter(5, 2);
  const long = { ...obj!, content: `${'# a comment\n'.repeat(2 ** 17)}${obj!.content as string}` };
  await page()
    .locator('html')
    .evaluate(
      (_, files) => {
        const made = files.map(({ name, content }) => new File([content], name));
        return window.sinew.open(made);
      },
      [skel!, long, attach!].map(({ name, content }) => ({ name, content: content as string })),
    );
  await expect(page().locator('.status .notice')).toHaveText(
    /could not be loaded; reload the page/,
  );
  await expect(status()).toHaveText(before!);
});
