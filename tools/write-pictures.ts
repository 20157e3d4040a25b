/**
 * Takes the pictures of the gallery (public/data/pictures), of the bundled poses and of the README
 * (docs/pictures) from the built app, in the browser of the tests: `npm run pictures`. The same
 * sources give the same pictures, except for the text of the page, whose fonts are the system's.
 */
import { execFileSync, spawn } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { type Browser, chromium, type Page } from '@playwright/test';
import { vec3 } from 'gl-matrix';
import type { PoseList } from '../src/app/bundled-poses.ts';
import type { Catalogue } from '../src/app/catalogue.ts';
import type { CaptureOptions, Scripting } from '../src/app/scripting.ts';
import { type Bounds, emptyBounds, includePositions } from '../src/core/bounds.ts';
import { displayTransform } from '../src/evaluation/display-transform.ts';
import { poseCamera } from '../src/view/picture/pose-picture.ts';
import { browserFlags, findBrowser } from './browser.mjs';
import { packageCommand, root } from './commands.mjs';
import { freePort } from './free-port.ts';

declare global {
  interface Window {
    sinew: Scripting;
  }
}

/** Pictures of the gallery: twice as large as they are shown, and a little closer than the page. */
const card: CaptureOptions = {
  width: 288,
  height: 216,
  views: [{ camera: { fieldOfView: (25 * Math.PI) / 180 } }],
};

const themes = ['light', 'dark'] as const;

/** Writes a picture of every bundled character in light and dark colors. */
async function writeCards(browser: Browser, address: string): Promise<void> {
  const folder = path.join(root, 'public/data/pictures');
  mkdirSync(folder, { recursive: true });
  const { characters, scenes } = readJson('public/data/catalogue.json') as Catalogue;
  for (const colorScheme of themes) {
    const page = await browser.newPage({ colorScheme, viewport: { width: 860, height: 480 } });
    for (const { id } of characters) {
      await openPage(page, `${address}?test&model=${id}`);
      write(path.join(folder, `${id}-${colorScheme}.jpg`), await capture(page, card));
    }
    for (const { id } of scenes) {
      await openPage(page, `${address}?test&model=${characters[0]!.id}`);
      await page.evaluate((scene) => window.sinew.openScene(scene), id);
      write(path.join(folder, `${id}-${colorScheme}.jpg`), await capture(page, card));
    }
    await page.close();
  }
}

/** Of the square of a pose in the library, in pixels: twice what the page shows. */
const poseSide = 160;

/** Writes, for each bundled character with poses, a column of pictures of them without background. */
async function writePoses(browser: Browser, address: string): Promise<void> {
  const { characters } = readJson('public/data/catalogue.json') as Catalogue;
  const page = await browser.newPage({ viewport: { width: 860, height: 480 } });
  for (const { id, poses: list } of characters) {
    if (list === undefined) continue;
    await openPage(page, `${address}?test&model=${id}`);
    const { poses } = readJson(`public/data/${list}`) as PoseList;
    await page.evaluate(() => window.sinew.pose({}));
    const rest = boundsOf(await positionsOf(page));
    const pictures: string[] = [];
    for (const { pose } of poses) {
      await page.evaluate((json) => void window.sinew.pose(json), pose);
      const camera = poseCamera(placed(boundsOf(await positionsOf(page)), rest));
      const options = { width: poseSide, height: poseSide, background: false, samples: 2 };
      const views = [{ camera: { ...camera, target: [...camera.target] as const } }];
      pictures.push(await captureText(page, { ...options, views, format: 'png' }));
    }
    write(
      path.join(root, 'public/data', list.replace(/\.json$/, '.webp')),
      await column(page, pictures),
    );
  }
  await page.close();
}

async function positionsOf(page: Page): Promise<readonly number[]> {
  return page.evaluate(() => Array.from(window.sinew.vertices('cpu')));
}

function boundsOf(positions: readonly number[]): Bounds {
  const bounds = emptyBounds();
  includePositions(bounds, positions, positions.length / 3);
  return bounds;
}

/** A box of a fitted character in scene space; the transform does not turn it. */
function placed(box: Bounds, rest: Bounds): Bounds {
  const { sceneFromCharacter } = displayTransform({ bounds: rest });
  const corner = (place: Float64Array): Float64Array =>
    vec3.transformMat4(new Float64Array(3), place, sceneFromCharacter) as Float64Array;
  return { min: corner(box.min), max: corner(box.max) };
}

/** Puts pictures below each other. */
async function column(page: Page, pictures: readonly string[]): Promise<Buffer> {
  const base64 = await page.evaluate(async (all) => {
    const canvas = document.createElement('canvas');
    const images = await Promise.all(
      all.map(async (text) => {
        const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
        return createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      }),
    );
    const side = images[0]!.width;
    canvas.width = side;
    canvas.height = side * images.length;
    const context = canvas.getContext('2d')!;
    images.forEach((image, index) => context.drawImage(image, 0, index * side));
    return canvas.toDataURL('image/webp', 0.85).replace(/^.*,/, '');
  }, pictures);
  return Buffer.from(base64, 'base64');
}

/** Writes the pictures that the README shows. */
async function writeReadmePictures(browser: Browser, address: string): Promise<void> {
  const folder = path.join(root, 'docs/pictures');
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });

  await openPage(page, `${address}?test&model=human`);
  write(path.join(folder, 'human.jpg'), await capture(page, { width: 1200, height: 720 }));

  await openPage(page, address);
  await page.waitForFunction(() => window.sinew.characters.length === 2);
  await page.getByRole('treeitem', { name: 'Left upper arm' }).click();
  await page.evaluate(() => window.sinew.settled());
  await screenshot(page, path.join(folder, 'page.jpg'));

  await openPage(page, `${address}?workspace=mannequin&model=human`);
  await page.keyboard.press('m');
  const view = (await page.locator('canvas').boundingBox())!;
  await pointAtForearm(page, view);
  await page.evaluate(() => window.sinew.settled());
  await screenshot(page, path.join(folder, 'mannequin.jpg'), view);

  write(path.join(folder, 'methods.jpg'), await comparison(page, address));
  await page.close();
}

/** Three methods on the twisted tube, with their differences in color. */
async function comparison(page: Page, address: string): Promise<Buffer> {
  await openPage(page, `${address}?model=tube`);
  await page.locator('canvas').focus();
  await page.keyboard.press('x');
  await page.locator('.worst-mark button').waitFor();
  const change = page.locator('.change-comparison');
  await change.locator('[data-command="compare-one-more"]').click();
  await change.locator('[data-command="comparison-layout"]').click();
  await page.locator('.top [data-tab="deform"]').click();
  await page.locator('.deform-lab [data-command="difference-colors"]').click();
  await page.evaluate(() => window.sinew.settled());
  return capture(page, { width: 1200, height: 560, samples: 2, labels: true });
}

type Box = Readonly<Record<'x' | 'y' | 'width' | 'height', number>>;

/** Moves the pointer over the view, row by row, until a forearm lights up. */
async function pointAtForearm(page: Page, { x, y, width, height }: Box): Promise<void> {
  for (let down = 0.3; down < 0.6; down += 0.03) {
    for (let across = 0.3; across < 0.7; across += 0.01) {
      await page.mouse.move(x + across * width, y + down * height);
      const lit = (await page.locator('.lit-bone').allTextContents()).join();
      if (/^\w+ forearm/.test(lit)) return;
    }
  }
  throw new Error('no forearm lights up under the pointer');
}

async function openPage(page: Page, address: string): Promise<void> {
  await page.goto(address);
  await page.evaluate(() => window.sinew.ready);
  await page.evaluate(() => window.sinew.settled());
}

async function capture(page: Page, options: CaptureOptions): Promise<Buffer> {
  return Buffer.from(await captureText(page, { ...options, format: 'jpeg' }), 'base64');
}

/** A picture's bytes in base64. */
async function captureText(page: Page, options: CaptureOptions): Promise<string> {
  return page.evaluate(async (given) => {
    const blob = await window.sinew.capture(given);
    const reader = new FileReader();
    const read = new Promise((resolve) => (reader.onload = resolve));
    reader.readAsDataURL(blob);
    await read;
    return (reader.result as string).replace(/^.*,/, '');
  }, options);
}

async function screenshot(page: Page, file: string, clip?: Box): Promise<void> {
  write(file, await page.screenshot({ type: 'jpeg', quality: 80, ...(clip && { clip }) }));
}

function write(file: string, bytes: Buffer): void {
  writeFileSync(file, bytes);
  console.log(`${path.relative(root, file)} ${(bytes.length / 1024).toFixed(1)} KB`);
}

function readJson(file: string): unknown {
  return JSON.parse(readFileSync(path.join(root, file), 'utf8'));
}

/** Builds the app and serves it on a free port. */
async function serve(): Promise<{ readonly address: string; close(): void }> {
  const [program = '', ...build] = packageCommand('vite', ['build', '--logLevel', 'warn']);
  execFileSync(program, build, { cwd: root, stdio: 'inherit' });
  const port = await freePort();
  const words = ['preview', '--host', '127.0.0.1', '--port', `${port}`, '--strictPort'];
  const server = spawn(program, packageCommand('vite', words).slice(1), { cwd: root });
  await new Promise<void>((resolve, reject) => {
    server.stdout.once('data', () => resolve());
    server.once('exit', () => reject(new Error('the built app could not be served')));
  });
  return { address: `http://127.0.0.1:${port}/`, close: () => server.kill() };
}

const { path: executablePath } = findBrowser();
const server = await serve();
const browser = await chromium.launch({
  ...(executablePath !== undefined && { executablePath }),
  chromiumSandbox: false,
  args: browserFlags,
});
try {
  await writeCards(browser, server.address);
  await writePoses(browser, server.address);
  await writeReadmePictures(browser, server.address);
} finally {
  await browser.close();
  server.close();
}
