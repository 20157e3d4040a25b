import { expect, type Page } from '@playwright/test';
import { capture, drop, openApp, openJoint, openView, verify } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { sharedPage, test } from './support/test.ts';

declare global {
  interface Window {
    context?: WEBGL_lose_context;
  }
}

// A small view is drawn sooner; nothing here is about its size.
test.use({ viewport: { width: 760, height: 420 } });

const page = sharedPage((page) => openView(page, 'model=tube'));

async function lose(page: Page): Promise<void> {
  await page.evaluate(() => {
    const gl = document.querySelector<HTMLCanvasElement>('canvas.scene')!.getContext('webgl2')!;
    // The extension is not to be had from a lost context.
    window.context ??= gl.getExtension('WEBGL_lose_context')!;
    window.context.loseContext();
  });
  await page.waitForTimeout(50); // the event comes in a task of its own
}

async function restore(page: Page): Promise<void> {
  await page.evaluate(async () => {
    const canvas = document.querySelector('canvas.scene')!;
    const restored = new Promise((resolve) => {
      canvas.addEventListener('webglcontextrestored', resolve, { once: true });
    });
    window.context!.restoreContext();
    await restored;
  });
}

test('a lost context comes back with the same pixels, and the pose', async () => {
  const before = await capture(page());
  const pose = await page().evaluate(() => window.sinew.pose());
  await lose(page());
  await restore(page());
  expect(await capture(page())).toEqual(before);
  expect(await page().evaluate(() => window.sinew.pose())).toEqual(pose);
  expect(await verify(page())).toMatchObject({ identical: true });
});

test('a texture, a morph and the pose of a clip come back too', async () => {
  await page().evaluate(() => window.sinew.open('insect'));
  await page().evaluate(() => {
    window.sinew.morphs({ insect_alert: 1, insect_breathe: 1 });
    window.sinew.seek(0.7);
  });
  const before = await capture(page());
  await page().evaluate(() => window.sinew.seek(0));
  expect(await capture(page()), 'the clip shows').not.toEqual(before);
  await lose(page());
  // What changes meanwhile is there when the context is.
  await page().evaluate(() => window.sinew.seek(0.7));
  await restore(page());
  expect(await capture(page())).toEqual(before);
  expect(await verify(page())).toMatchObject({ identical: true });
});

test('lost while a character is read, the picture is the same as if it had not been', async () => {
  await page().evaluate(() => window.sinew.open('human'));
  const expected = await capture(page());
  await page().evaluate(() => window.sinew.open('tube'));
  const opening = page().evaluate(() => window.sinew.open('human'));
  await lose(page());
  await opening;
  await restore(page());
  expect(await capture(page())).toEqual(expected);
});

test('lost while it is captured, capturing says so, and works again after', async () => {
  const before = await capture(page());
  await lose(page());
  const refused = await page().evaluate(() =>
    window.sinew.capture().then(
      () => 'captured',
      () => 'refused',
    ),
  );
  expect(refused).toBe('refused');
  await restore(page());
  expect(await capture(page())).toEqual(before);
});

test('a character that is dropped meanwhile is there when the context is', async () => {
  await lose(page());
  await drop(page(), madeCharacter(5, 2));
  await restore(page());
  expect(await verify(page())).toMatchObject({ identical: true });
});

test('lost in the middle of a drag, the page says so and the drag goes on', async ({ page }) => {
  await openApp(page, 'model=tube');
  const { slider } = await openJoint(page, 'joint 02', 'X');
  const box = (await slider.boundingBox())!;
  /** To the right, with things that happen at two places of the way. */
  const drag = async (...between: (() => Promise<void>)[]): Promise<void> => {
    const moveTo = (part: number): Promise<void> =>
      page.mouse.move(box.x + box.width * part, box.y + box.height / 2);
    await moveTo(0.5);
    await page.mouse.down();
    await moveTo(0.6);
    await between[0]?.();
    await moveTo(0.7);
    await between[1]?.();
    await moveTo(0.8);
    await page.mouse.up();
  };
  await drag();
  const pose = await page.evaluate(() => window.sinew.pose());
  const kept = await capture(page);
  expect(pose.joints!['joint 02']![0]).toBeGreaterThan(0.5);
  await page.keyboard.press('Control+z');

  const message = page.locator('.message');
  await drag(
    async () => {
      await lose(page);
      await expect(message).toContainText('lost');
    },
    async () => {
      await restore(page);
      await expect(message).toBeHidden();
    },
  );
  expect(await page.evaluate(() => window.sinew.pose())).toEqual(pose);
  expect(await capture(page)).toEqual(kept);
});
