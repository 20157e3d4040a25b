import { gzipSync } from 'node:zlib';
import { expect } from '@playwright/test';
import './support/app.ts';
import { sharedPage, test } from './support/test.ts';

const kilobyte = 1000;

// What a single first visit requested and received.
const asked: string[] = [];
const statuses: number[] = [];
const scripts = new Map<string, { readonly start: number; readonly body: Promise<Buffer> }>();
let transferred = 0;

const page = sharedPage(async (page) => {
  const session = await page.context().newCDPSession(page);
  await session.send('Network.enable');
  session.on(
    'Network.loadingFinished',
    ({ encodedDataLength }) => (transferred += encodedDataLength),
  );
  page.on('request', (request) => asked.push(request.url()));
  page.on('response', (response) => {
    statuses.push(response.status());
    const type = response.headers()['content-type'] ?? '';
    if (!/javascript|wasm/.test(type)) return;
    const { startTime: start } = response.request().timing();
    // The body of a worker's script goes with its worker.
    const body = response.body().catch(() => Buffer.alloc(0));
    scripts.set(response.url(), { start, body });
  });
  await page.goto('./');
  await page.evaluate(() => window.sinew.ready);
  await expect.poll(() => page.evaluate(() => window.sinew.characters.length)).toBe(2);
  await page.waitForLoadState('networkidle');
});

test('the first picture needs at most 60 KB of gzipped scripts', async () => {
  const shown = await page().evaluate(
    () => performance.timeOrigin + performance.getEntriesByName('first-frame')[0]!.startTime,
  );
  const sizes: [string, number][] = [];
  for (const [url, { start, body }] of scripts) {
    const size = gzipSync(await body, { level: 9 }).length;
    const name = url.slice(url.lastIndexOf('/') + 1);
    sizes.push([`${name}${start > shown ? ' (later)' : ''}`, size]);
  }
  const early = sizes.filter(([name]) => !name.endsWith('(later)'));
  const total = early.reduce((sum, [, size]) => sum + size, 0);
  annotate('scripts, gzipped', sizes.map(([name, size]) => `${name} ${size}`).join(', '));
  annotate('before the first picture', `${total} bytes`);
  expect(early.length).toBeGreaterThan(0);
  for (const [name, size] of early) expect(size, name).toBeGreaterThan(100);
  expect(sizes.filter(([name]) => name.includes('.wasm'))).toEqual([
    [expect.stringMatching(/\.wasm \(later\)$/), expect.any(Number)],
  ]);
  expect(sizes.map(([name]) => name)).toContainEqual(expect.stringMatching(/^refined.*\(later\)$/));
  expect(total).toBeLessThanOrEqual(60 * kilobyte);
  expect(sizes.length, 'the panels come later').toBeGreaterThan(early.length);
});

test('the first visit transfers at most 550 KB until its first picture, and 1.2 MB in all', async () => {
  annotate('first visit', `${transferred} bytes in ${statuses.length} responses`);
  const early = await page().evaluate(() => {
    const mark = performance.getEntriesByName('first-frame')[0]!.startTime;
    const resources = performance.getEntriesByType('resource') as PerformanceResourceTiming[];
    return resources
      .filter(({ responseEnd }) => responseEnd < mark)
      .reduce((sum, { encodedBodySize }) => sum + encodedBodySize, 0);
  });
  annotate('before the first picture', `${early} bytes`);
  expect(early).toBeGreaterThan(200 * kilobyte);
  expect(early).toBeLessThanOrEqual(550 * kilobyte);
  expect(statuses.length).toBeGreaterThan(5);
  expect(statuses.filter((status) => status !== 200)).toEqual([]);
  // The characters alone are several hundred KB; a smaller sum would mean that something was not
  // counted.
  expect(transferred).toBeGreaterThan(300 * kilobyte);
  expect(transferred).toBeLessThanOrEqual(1200 * kilobyte);
});

test('the page works from a sub-path, and every address that it requests is below it', ({
  baseURL,
}) => {
  expect(new URL(baseURL!).pathname.split('/').length).toBeGreaterThan(2);
  expect(asked.filter((url) => !url.startsWith(baseURL!))).toEqual([]);
});

function annotate(type: string, description: string): void {
  test.info().annotations.push({ type, description });
}
