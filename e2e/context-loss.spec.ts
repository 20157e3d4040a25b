import { expect, type Page } from '@playwright/test';
import { capture, drop, openApp, openJoint, verify } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, sharedPage, test } from './support/test.ts';

declare global {
  interface Window {
    context?: WEBGL_lose_context;
  }
}

// A small view is drawn faster, and its size does not matter here.
test.use({ ...coarse, viewport: { width: 960, height: 420 } });

const page = sharedPage((page) => openApp(page, 'model=tube'));

async function lose(page: Page): Promise<void> {
  await page.evaluate(() => {
    const gl = document.querySelector<HTMLCanvasElement>('canvas.scene')!.getContext('webgl2')!;
    // A lost context does not return the extension.
    window.context ??= gl.getExtension('WEBGL_lose_context')!;
    window.context.loseContext();
  });
  await page.waitForTimeout(50); // the event is fired in a task of its own
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

test('when the context is lost during a drag, the page says so and the drag continues', async () => {
  const { slider } = await openJoint(page(), 'joint 02', 'X');
  const box = (await slider.boundingBox())!;
  /** Drags to the right, and runs the given actions at two points on the way. */
  const drag = async (...between: (() => Promise<void>)[]): Promise<void> => {
    const moveTo = (part: number): Promise<void> =>
      page().mouse.move(box.x + box.width * part, box.y + box.height / 2);
    await moveTo(0.5);
    await page().mouse.down();
    await moveTo(0.6);
    await between[0]?.();
    await moveTo(0.7);
    await between[1]?.();
    await moveTo(0.8);
    await page().mouse.up();
  };
  await drag();
  const pose = await page().evaluate(() => window.sinew.pose());
  const kept = await capture(page());
  expect(pose.joints!['joint 02']![0]).toBeGreaterThan(0.5);
  await page().keyboard.press('Control+z');

  const message = page().locator('.message');
  await drag(
    async () => {
      await lose(page());
      await expect(message).toContainText('lost');
    },
    async () => {
      await restore(page());
      await expect(message).toBeHidden();
    },
  );
  expect(await page().evaluate(() => window.sinew.pose())).toEqual(pose);
  expect(await capture(page())).toEqual(kept);
  await page().keyboard.press('Control+z');
});

test('a restored context shows the same pixels and pose', async () => {
  const before = await capture(page());
  const pose = await page().evaluate(() => window.sinew.pose());
  await lose(page());
  await restore(page());
  expect(await capture(page())).toEqual(before);
  expect(await page().evaluate(() => window.sinew.pose())).toEqual(pose);
  expect(await verify(page())).toMatchObject({ identical: true });
});

test('a texture, a morph and the pose of a clip are restored too', async () => {
  await page().evaluate(() => window.sinew.open('insect'));
  await page().evaluate(() => {
    window.sinew.morphs({ insect_alert: 1, insect_breathe: 1 });
    window.sinew.seek(0.7);
  });
  const before = await capture(page());
  await page().evaluate(() => window.sinew.seek(0));
  expect(await capture(page()), 'the clip shows').not.toEqual(before);
  await lose(page());
  // A change made while the context is lost shows once it is restored.
  await page().evaluate(() => window.sinew.seek(0.7));
  await restore(page());
  expect(await capture(page())).toEqual(before);
  expect(await verify(page())).toMatchObject({ identical: true });
});

test('losing the context while a character is read does not change the resulting picture', async () => {
  await page().evaluate(() => window.sinew.open('human'));
  const expected = await capture(page());
  await page().evaluate(() => window.sinew.open('tube'));
  const opening = page().evaluate(() => window.sinew.open('human'));
  await lose(page());
  await opening;
  await restore(page());
  expect(await capture(page())).toEqual(expected);
});

test('capturing fails with a message while the context is lost, and works again after', async () => {
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

test('a character that is dropped while the context is lost shows once it is restored', async () => {
  await lose(page());
  await drop(page(), madeCharacter(5, 2));
  await restore(page());
  expect(await verify(page())).toMatchObject({ identical: true });
});
