import type { Browser, Page } from '@playwright/test';
import { cpSync } from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';
import { root } from '../../tools/commands.mjs';
import { launchBrowser } from '../harness/browser.ts';
import { buildApp, buildPages } from '../harness/build-pages.ts';
import { type BenchOptions, expectRight, type GroupResult, timesSlower } from '../harness/group.ts';
import { type Contender, measure } from '../harness/measure.ts';
import { serve } from '../harness/serve.ts';

const viewport = { width: 1280, height: 863 };

declare global {
  interface Window {
    /** Milliseconds since the visit began until a pixel of the first picture could be read. */
    firstPixel?: number;
  }
}

/** What a first visit sees and loads, against the smallest viewer with three.js. */
export async function firstFrame({ rounds }: BenchOptions): Promise<GroupResult> {
  const peerFolder = await buildPages('three-viewer', { viewer: 'peers/three-viewer.mjs' });
  cpSync(path.join(root, 'public/data'), path.join(peerFolder, 'data'), { recursive: true });
  const servers = [await serve(await buildApp()), await serve(peerFolder)] as const;
  const browser = await launchBrowser();
  try {
    const sinew = `${servers[0].address}/`;
    const first = await visit(browser, sinew);
    const [width, height] = first.size;
    const three = `${servers[1].address}/viewer.page?width=${width}&height=${height}`;
    const peer = await visit(browser, three);
    for (const { size, colors } of [first, peer]) {
      expectRight(size[0] === width && size[1] === height, `a picture of ${size.join(' × ')}`);
      expectRight(colors > 50, `the first picture has ${colors} colors`);
    }
    const contenders = [
      visitContender('sinew', browser, sinew),
      visitContender('three', browser, three),
    ];
    // A visit takes longer than anything else, and differs less.
    const samples = await measure(contenders, Math.ceil(rounds / 2));
    return {
      samples,
      values: {
        'first-frame': timesSlower(samples, 'sinew', 'three'),
        'first-scripts': { value: first.scriptBytes / 1000 },
      },
      counts: {
        'bytes of scripts before the first frame, gzipped': first.scriptBytes,
        'the same, three.js': peer.scriptBytes,
      },
    };
  } finally {
    await browser.close();
    for (const server of servers) server.close();
  }
}

/** Each visit is the first of a new context; the browser is warm. */
function visitContender(id: string, browser: Browser, address: string): Contender {
  return {
    id,
    async sample() {
      const { milliseconds } = await visit(browser, address);
      return { wall: milliseconds };
    },
  };
}

interface Visit {
  readonly milliseconds: number;
  readonly scriptBytes: number;
  readonly size: readonly [width: number, height: number];
  /** The number of different colors of the picture. */
  readonly colors: number;
}

async function visit(browser: Browser, address: string): Promise<Visit> {
  const context = await browser.newContext({ viewport });
  const page = await context.newPage();
  await page.addInitScript(timeFirstPixel);
  const scripts: Script[] = [];
  page.on('response', (response) => {
    const type = response.headers()['content-type'] ?? '';
    if (!/javascript|wasm/.test(type)) return;
    const { startTime: start } = response.request().timing();
    // The body of a worker's script goes with its worker, long after the first picture.
    scripts.push({ start, body: response.body().catch(() => Buffer.alloc(0)) });
  });
  await page.goto(address);
  await page.waitForFunction(() => window.firstPixel !== undefined, null, { timeout: 120_000 });
  const milliseconds = await page.evaluate(() => window.firstPixel!);
  const canvas = page.locator('canvas');
  const size = await canvas.evaluate(
    ({ width, height }: HTMLCanvasElement) => [width, height] as const,
  );
  const scriptBytes = await bytesBefore(page, scripts, milliseconds);
  const colors = await colorsOf(page);
  await context.close();
  return { milliseconds, scriptBytes, size, colors };
}

/** Runs in the page before its scripts. Both programs mark their first picture when it is drawn. */
function timeFirstPixel(): void {
  const mark = performance.mark.bind(performance);
  performance.mark = (name, options) => {
    const entry = mark(name, options);
    const gl = document.querySelector('canvas')?.getContext('webgl2');
    if (name === 'first-frame' && gl) {
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      window.firstPixel = performance.now();
    }
    return entry;
  };
}

interface Script {
  /** When it was requested, in milliseconds since 1970. */
  readonly start: number;
  readonly body: Promise<Buffer>;
}

/** The gzipped size of the scripts that were asked for before the first picture. */
async function bytesBefore(
  page: Page,
  scripts: readonly Script[],
  milliseconds: number,
): Promise<number> {
  const shown = milliseconds + (await page.evaluate(() => performance.timeOrigin));
  let sum = 0;
  for (const { start, body } of scripts) {
    if (start <= shown) sum += gzipSync(await body, { level: 9 }).length;
  }
  return sum;
}

/** Counts the colors of a screenshot of the view, which is what a visitor sees. */
async function colorsOf(page: Page): Promise<number> {
  const { PNG } = await import('pngjs');
  const { data } = PNG.sync.read(await page.locator('canvas').screenshot());
  return new Set(new Uint32Array(data.buffer, data.byteOffset, data.length / 4)).size;
}
