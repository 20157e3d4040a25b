import { expect, type Page } from '@playwright/test';
import { PNG } from 'pngjs';
import type { CaptureOptions } from '../src/app/scripting.ts';
import { startCamera } from '../src/document/camera.ts';
import { studio } from '../src/document/environment.ts';
import { lightHandles } from '../src/view/light-handles.ts';
import { pixelsIn } from '../src/view/overlay.ts';
import { bytesOf, choose, openView } from './support/app.ts';
import { cameraOf, typeNumber } from './support/controls.ts';
import { drawPlainly, openBundled, sharedPage, test } from './support/test.ts';

const page = sharedPage(async (page) => {
  await drawPlainly(page);
  await openBundled(page, 'small');
  await openView(page, 'model=human');
});
const [width, height] = [320, 240];

const undo = () => page().locator('[data-command="undo"]');
const undoAll = async (): Promise<void> => {
  while (await undo().isEnabled()) await undo().dispatchEvent('click');
};

/** The camera of all pictures; a low one, which sees much in the floor. */
const camera = { azimuth: 0.4, elevation: 0.1, distance: 3, fieldOfView: 0.5 } as const;
const target = [0, 0.5, 0] as const;

async function captured(options: CaptureOptions = {}): Promise<PNG> {
  const all = { width, height, views: [{ camera: { ...camera, target } }], ...options };
  const blob = await page().evaluateHandle((options) => window.sinew.capture(options), all);
  return PNG.sync.read(await bytesOf(blob));
}

test('no pixel of the floor is darker than one layer of planar shadow makes it', async () => {
  const darkness = 0.5;
  await choose(page(), 'Floor', 'Plain');
  await typeNumber(page(), 'Key light Around °', 90);
  await typeNumber(page(), 'Key light Above °', 14);
  await typeNumber(page(), 'Darkness of the shadow', darkness);
  const areas: number[] = [];
  const measure = async (): Promise<void> => {
    await choose(page(), 'Shadow', 'Off');
    const [plain, actors] = [await captured(), await captured({ background: false })];
    await choose(page(), 'Shadow', 'Sharp, floor alone');
    const shadowed = await captured();
    let [whole, tooDark, elsewhere] = [0, 0, 0];
    for (let at = 0; at < plain.data.length; at += 4) {
      if (plain.data[at] === shadowed.data[at]) continue;
      if (actors.data[at + 3] === 255) elsewhere++;
      if (actors.data[at + 3] !== 0) continue;
      const [before, after] = [linear(plain.data[at]!), linear(shadowed.data[at]!)];
      // One of the display's 255 steps more or less, by rounding.
      if (after < linear(encoded(before * (1 - darkness)) - 1.5)) tooDark++;
      else if (after < before * (1 - darkness) * 1.05) whole++;
    }
    expect([tooDark, elsewhere], 'pixels').toEqual([0, 0]);
    areas.push(whole);
  };
  await measure();
  await page().evaluate(() => window.sinew.add('dog'));
  await measure();
  await page().evaluate(() => window.sinew.remove('human'));
  await measure();
  const [human, both, dog] = areas;
  expect(Math.min(human!, dog!)).toBeGreaterThan(300);
  expect(both! + 40, 'the shadows overlap').toBeLessThan(human! + dog!);
  await undoAll();
});

test('a light below the floor casts no planar shadow', async () => {
  await choose(page(), 'Shadow', 'Off');
  const plain = await captured();
  await choose(page(), 'Shadow', 'Sharp, floor alone');
  expect((await captured()).data.equals(plain.data)).toBe(false);
  await typeNumber(page(), 'Key light Above °', -20);
  const below = await captured();
  await choose(page(), 'Shadow', 'Off');
  expect((await captured()).data.equals(below.data)).toBe(true);
  await undoAll();
});

test('the floor mirrors the picture of the mirrored camera, as Fresnel says', async () => {
  const plain = await captured();
  const actors = await captured({ background: false });
  const mirrored = { ...camera, target: [0, -0.5, 0] as const, elevation: -camera.elevation };
  const seen = await captured({ background: false, views: [{ camera: mirrored }] });
  await typeNumber(page(), 'Reflection in the floor', 1);
  const shown = await captured();
  let [compared, wrong] = [0, 0];
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const at = (y * width + x) * 4;
      const floor = floorAt(x, y);
      if (!floor || actors.data[at + 3] !== 0) continue;
      const from = ((height - 1 - y) * width + x) * 4;
      const share = floor.fresnel * floor.share;
      const alpha = (share * seen.data[from + 3]!) / 255;
      const gap = Math.max(
        ...[0, 1, 2].map((channel) => {
          const [under, over] = [plain.data[at + channel]!, seen.data[from + channel]!];
          return Math.abs(shown.data[at + channel]! - (over * alpha + under * (1 - alpha)));
        }),
      );
      if (gap > 2) wrong++;
      if (alpha > 0.2) compared++;
    }
  }
  expect(compared).toBeGreaterThan(250);
  expect(wrong).toBeLessThanOrEqual(0.001 * width * height);
  await undoAll();
});

test('a light is dragged by its disc: one step of undo, and Escape takes it back', async () => {
  const around = page().locator('input[aria-label="Key light Around °"]');
  const above = page().locator('input[aria-label="Key light Above °"]');
  const canvas = page().locator('canvas.scene');
  await canvas.focus();
  await page().keyboard.press('u');
  const box = (await canvas.boundingBox())!;
  const { azimuth, elevation } = await cameraOf(page());
  const degrees = Math.PI / 180;
  const view = {
    camera: {
      ...{ ...startCamera, azimuth: azimuth * degrees, elevation: elevation * degrees },
      fieldOfView: 28 * degrees,
    },
    ...{ width: box.width, height: box.height },
  };
  const [key] = lightHandles(studio, view);
  const [right, up] = pixelsIn(view)(key!.place);
  const start = [box.x + box.width / 2 + right, box.y + box.height / 2 - up] as const;
  await page().mouse.move(...start);
  await expect(page().locator('.active-dof')).toContainText('Key light -18.0° around');
  await page().mouse.down();
  await page().mouse.move(start[0] + 30, start[1] + 40, { steps: 3 });
  const moved = [Number(await around.inputValue()), Number(await above.inputValue())];
  expect(moved[0]).toBeGreaterThan(-18);
  expect(moved[1]).toBeLessThan(48);
  await page().keyboard.press('Escape');
  await page().mouse.up();
  expect(Number(await around.inputValue())).toBe(-18);
  await expect(undo()).toBeDisabled();
  await page().mouse.move(...start);
  await page().mouse.down();
  await page().mouse.move(start[0] + 30, start[1] + 40, { steps: 3 });
  await page().mouse.up();
  await expect(undo()).toHaveAttribute('title', /Key light's direction/);
  await undo().dispatchEvent('click');
  await expect(undo()).toBeDisabled();
  expect([Number(await around.inputValue()), Number(await above.inputValue())]).toEqual([-18, 48]);
  await canvas.focus();
  await page().keyboard.press('u');
});

test('a preset is one step of undo, and everything comes back after the context was lost', async () => {
  const first = await captured();
  await choose(page(), 'Preset', 'Night');
  const night = await captured();
  expect(night.data.equals(first.data)).toBe(false);
  await loseContext(page());
  expect((await captured()).data.equals(night.data)).toBe(true);
  const objects = await page().evaluate(() => window.sinew.liveObjects);
  await undo().dispatchEvent('click');
  await expect(undo()).toBeDisabled();
  expect((await captured()).data.equals(first.data)).toBe(true);
  await choose(page(), 'Preset', 'Night');
  await captured();
  expect(await page().evaluate(() => window.sinew.liveObjects)).toEqual(objects);
  await undoAll();
});

test('a transparent background is empty in pictures, where the floor fades into it', async () => {
  await choose(page(), 'Background', 'Transparent');
  const { data } = await captured();
  const alphaAt = (x: number, y: number): number => data[(y * width + x) * 4 + 3]!;
  expect([alphaAt(4, 4), alphaAt(width / 2, height - 4)]).toEqual([0, 255]);
  expect(new Set(data.filter((_, at) => at % 4 === 3)).size).toBeGreaterThan(50);
  const canvas = page().locator('canvas.scene');
  const [x, y] = [10, 10];
  const shown = PNG.sync.read(await canvas.screenshot());
  const colors = new Set(
    [0, 8, 16, 24].map((step) => shown.data.readUInt32BE((y * shown.width + x + step) * 4)),
  );
  expect(colors.size, 'checks on the page').toBe(2);
  await undoAll();
});

/** The place of the floor behind a pixel, by how much it mirrors there, and how little it fades. */
function floorAt(x: number, y: number): { fresnel: number; share: number } | null {
  const { azimuth, elevation, distance, fieldOfView } = camera;
  const [sin, cos] = [Math.sin(azimuth), Math.cos(azimuth)];
  const [rise, level] = [Math.sin(elevation), Math.cos(elevation)];
  const eye = [
    target[0] + distance * level * sin,
    target[1] + distance * rise,
    target[2] + distance * level * cos,
  ];
  const half = Math.tan(fieldOfView / 2);
  const right = ((2 * (x + 0.5)) / width - 1) * half * (width / height);
  const up = (1 - (2 * (y + 0.5)) / height) * half;
  const ray = [
    -sin * level + right * cos - up * sin * rise,
    -rise + up * level,
    -cos * level - right * sin - up * cos * rise,
  ];
  if (ray[1]! >= -1e-6) return null;
  const along = -eye[1]! / ray[1]!;
  const away = Math.hypot(eye[0]! + along * ray[0]!, eye[2]! + along * ray[2]!);
  const part = Math.min(1, Math.max(0, (away - 0.8) / (5 - 0.8)));
  const cosine = -ray[1]! / Math.hypot(...ray);
  return {
    fresnel: 0.04 + 0.96 * (1 - cosine) ** 5,
    share: 1 - part * part * (3 - 2 * part),
  };
}

function linear(byte: number): number {
  const value = Math.max(0, byte) / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}

function encoded(value: number): number {
  return 255 * (value <= 0.0031308 ? value * 12.92 : 1.055 * value ** (1 / 2.4) - 0.055);
}

async function loseContext(page: Page): Promise<void> {
  await page.evaluate(async () => {
    const canvas = document.querySelector<HTMLCanvasElement>('canvas.scene')!;
    const extension = canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
    const happened = (type: string): Promise<unknown> =>
      new Promise((resolve) => canvas.addEventListener(type, resolve, { once: true }));
    const lost = happened('webglcontextlost');
    extension.loseContext();
    await lost;
    await new Promise((resolve) => setTimeout(resolve, 50));
    const restored = happened('webglcontextrestored');
    extension.restoreContext();
    await restored;
  });
}
