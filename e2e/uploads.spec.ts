import { expect, type Page } from '@playwright/test';
import { choose, drop, openSmallView, verify } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { test } from './support/test.ts';

// What is sent to the GPU, counted at WebGL's own calls.

interface Sent {
  /** To buffers, bytes. */
  geometry: number;
  /** Pictures of solids that were drawn: bones, axes. */
  solids: number;
}

declare global {
  interface Window {
    sent: Sent;
  }
}

/** Runs in the page before its scripts. */
function countSent(): void {
  window.sent = { geometry: 0, solids: 0 };
  const gl = WebGL2RenderingContext.prototype;
  const { bufferData, bufferSubData, drawElementsInstanced } = gl;
  gl.bufferData = function (this: WebGL2RenderingContext, ...parameters: unknown[]) {
    const [, content] = parameters;
    if (ArrayBuffer.isView(content)) window.sent.geometry += content.byteLength;
    bufferData.apply(this, parameters as Parameters<typeof bufferData>);
  };
  gl.bufferSubData = function (this: WebGL2RenderingContext, ...parameters: unknown[]) {
    window.sent.geometry += (parameters[2] as ArrayBufferView).byteLength;
    bufferSubData.apply(this, parameters as Parameters<typeof bufferSubData>);
  };
  gl.drawElementsInstanced = function (...parameters) {
    window.sent.solids++;
    drawElementsInstanced.apply(this, parameters);
  };
}

/** What is sent by an action and the pictures that follow it. */
async function sentBy(page: Page, action: () => Promise<unknown>): Promise<Sent> {
  const drawn = () =>
    page.evaluate(
      () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
    );
  await drawn();
  await page.evaluate(() => (window.sent = { geometry: 0, solids: 0 }));
  await action();
  await drawn();
  return page.evaluate(() => window.sent);
}

test('only what changed is sent', async ({ page }) => {
  await page.addInitScript(countSent);
  await openSmallView(page, 'model=insect');
  await page.locator('canvas').focus();

  await test.step('orbiting sends nothing, with skin, bones, boxes and axes', async () => {
    for (const key of ['s', 's', 'a']) await page.keyboard.press(key);
    for (const style of ['Boxes', 'Lines', 'Sticks']) {
      await choose(page, 'Skeleton as', style);
      await page.locator('canvas').focus();
      const { geometry, solids } = await sentBy(page, async () => {
        for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowLeft');
      });
      expect([style, geometry]).toEqual([style, 0]);
      expect(solids, style).toBeGreaterThan(0);
    }
  });

  await test.step('a pose sends the palette and the solids alone', async () => {
    await page.keyboard.press('a');
    const { jointCount, vertexCount } = await page.evaluate(() => {
      const { joints, vertexCount } = window.sinew.characters[0]!;
      return { jointCount: joints.length, vertexCount };
    });
    const { geometry } = await sentBy(page, () => page.evaluate(() => window.sinew.seek(0.4)));
    expect(geometry).toBeGreaterThan(0);
    expect(geometry).toBeLessThan(jointCount * 1000);
    expect(geometry).toBeLessThan(vertexCount * 12);
  });

  await test.step('normalized weights are sent by the rows that differ, beside the palette', async () => {
    const files = madeCharacter(5, 2).map(({ name, content }) => {
      if (!name.endsWith('.attach')) return { name, content };
      const rows = String(content).split('\n');
      for (const row of uneven) rows[row] = rows[row]!.replace('0.5000', '0.2500');
      return { name, content: rows.join('\n') };
    });
    await drop(page, files);
    const normalize = page.locator('.lil-controller:has-text("weights") input[type=checkbox]');
    const { geometry } = await sentBy(page, () =>
      normalize.evaluate((box: HTMLInputElement) => box.click()),
    );
    expect(geometry).toBe(uneven.length * weightBytes + 5 * entryBytes);
    expect(await verify(page)).toMatchObject({ identical: true });
  });
});

test('a view that is built anew has its textures in its first picture', async ({ page }) => {
  await openSmallView(page, 'model=insect');
  const [first, settled] = await page.evaluate(async () => {
    const canvas = document.querySelector('canvas')!;
    /** Of the picture that is drawn next. */
    const nextPicture = () =>
      new Promise<string>((resolve) => {
        requestAnimationFrame(() => resolve(canvas.toDataURL()));
      });
    const press = (key: string, ctrlKey = false) =>
      canvas.dispatchEvent(new KeyboardEvent('keydown', { key, ctrlKey, bubbles: true }));
    await window.sinew.open('tube');
    await window.sinew.settled();
    press('z', true);
    const first = await nextPicture();
    await window.sinew.settled();
    // Translucent and back: the same is drawn again.
    press('t');
    press('t');
    return [first, await nextPicture()];
  });
  expect(await page.evaluate(() => window.sinew.characters.map(({ name }) => name))).toEqual([
    'insect',
  ]);
  expect(first).toBe(settled);
});

/** Rows whose weights do not sum to one, in two runs. */
const uneven = [3, 4, 9];
/** Of a vertex in one pair of attributes, and of a joint in the palette. */
const [weightBytes, entryBytes] = [16, 48];
