import { expect, type Page } from '@playwright/test';
import { choose, drop, openSmallView, verify, openTab } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { test } from './support/test.ts';

// What is sent to the GPU, counted by wrapping WebGL's own functions.

interface Sent {
  /** Bytes that are sent to buffers. */
  geometry: number;
  /** Bytes that are sent to textures. */
  texels: number;
  /** Runs of the skinning stage. */
  skinned: number;
  /** Draws into the picture, and into anything else: the maps of the shadows. */
  drawn: number;
  shadows: number;
  /** Draws of instanced solids: bones, axes. */
  solids: number;
}

declare global {
  interface Window {
    sent: Sent;
  }
}

/** Runs in the page before its scripts. */
function countSent(): void {
  window.sent = { geometry: 0, texels: 0, skinned: 0, drawn: 0, shadows: 0, solids: 0 };
  const gl = WebGL2RenderingContext.prototype;
  const { bufferData, bufferSubData, texSubImage2D, beginTransformFeedback } = gl;
  const { viewport, drawElements, drawArrays, drawElementsInstanced } = gl;
  let intoPicture = false;
  gl.viewport = function (x, y, width, height) {
    intoPicture = width === this.drawingBufferWidth && height === this.drawingBufferHeight;
    viewport.call(this, x, y, width, height);
  };
  const note = (): void => {
    if (intoPicture) window.sent.drawn++;
    else window.sent.shadows++;
  };
  gl.drawElements = function (...parameters) {
    note();
    drawElements.apply(this, parameters);
  };
  gl.drawArrays = function (...parameters) {
    note();
    drawArrays.apply(this, parameters);
  };
  gl.beginTransformFeedback = function (mode) {
    window.sent.skinned++;
    beginTransformFeedback.call(this, mode);
  };
  gl.texSubImage2D = function (this: WebGL2RenderingContext, ...parameters: unknown[]) {
    const content = parameters.find((each) => ArrayBuffer.isView(each));
    if (content) window.sent.texels += content.byteLength;
    texSubImage2D.apply(this, parameters as unknown as Parameters<typeof texSubImage2D>);
  };
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

/** Counts what an action, and the pictures that follow it, send to the GPU. */
async function sentBy(page: Page, action: () => Promise<unknown>): Promise<Sent> {
  const drawn = () =>
    page.evaluate(
      () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
    );
  await drawn();
  await page.evaluate(() => {
    for (const kind in window.sent) window.sent[kind as keyof Sent] = 0;
  });
  await action();
  await drawn();
  return page.evaluate(() => window.sent);
}

test('only what changed is sent', async ({ page }) => {
  await page.addInitScript(countSent);
  await openSmallView(page, 'model=insect');
  await page.locator('canvas.scene').focus();

  await test.step('orbiting and drawing again send nothing, skin nothing and draw no shadow', async () => {
    const orbit = () => page.keyboard.press('ArrowLeft');
    // Toggling twice within a task draws the same picture again.
    const again = () =>
      page.locator('canvas.scene').evaluate((canvas) => {
        for (let i = 0; i < 2; i++) {
          canvas.dispatchEvent(new KeyboardEvent('keydown', { key: 't', bubbles: true }));
        }
      });
    for (const action of [orbit, again]) {
      const { drawn, ...others } = await sentBy(page, action);
      expect(drawn).toBeGreaterThan(2);
      expect(others).toEqual({ geometry: 0, texels: 0, skinned: 0, shadows: 0, solids: 0 });
    }
    const posed = await sentBy(page, () => page.evaluate(() => window.sinew.seek(0.3)));
    expect(posed).toMatchObject({ skinned: 1, texels: 0 });
    // The key light's map, the map from below, and its two blurs.
    expect(posed.shadows).toBeGreaterThanOrEqual(4);
  });

  await test.step('orbiting sends nothing, with skin, bones, boxes and axes', async () => {
    for (const key of ['s', 's', 'a']) await page.keyboard.press(key);
    for (const style of ['Boxes', 'Lines', 'Sticks']) {
      await choose(page, 'Skeleton as', style);
      await page.locator('canvas.scene').focus();
      const { geometry, solids } = await sentBy(page, async () => {
        for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowLeft');
      });
      expect([style, geometry]).toEqual([style, 0]);
      expect(solids, style).toBeGreaterThan(0);
    }
  });

  await test.step('a pose sends only the palette and the solids', async () => {
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

  await test.step('normalizing weights sends the rows that differ, and the palette', async () => {
    await openTab(page, 'deform');
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

test('the first picture of a rebuilt view has its textures', async ({ page }) => {
  await openSmallView(page, 'model=insect');
  const [first, settled] = await page.evaluate(async () => {
    const canvas = document.querySelector('canvas')!;
    /** The content of the next picture. */
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
    // Toggling the translucent skin twice draws the same picture again.
    press('t');
    press('t');
    return [first, await nextPicture()];
  });
  expect(await page.evaluate(() => window.sinew.characters.map(({ name }) => name))).toEqual([
    'insect',
  ]);
  expect(first).toBe(settled);
});

/** Rows whose weights do not sum to one; they form two contiguous runs. */
const uneven = [3, 4, 9];
/** The bytes of a vertex in one pair of attributes, and of a joint in the palette. */
const [weightBytes, entryBytes] = [16, 48];
