import { expect, type Page } from '@playwright/test';
import { unzipSync } from 'fflate';
import { PNG } from 'pngjs';
import type { CaptureOptions } from '../src/app/scripting.ts';
import type { MovieSettings } from '../src/view/movie/movie-settings.ts';
import { bytesOf, openApp, openSmallView } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { coarse, drawPlainly, openBundled, sharedPage, test } from './support/test.ts';

const size = { width: 160, height: 96 };
/** Eight frames of a walk, which begin between two frames of its own. */
const short = { ...size, range: 'typed', from: 0.11, to: 0.91, rate: 10 } as const;
const timeOf = (frame: number): number => short.from + frame / short.rate;
/** The mean difference of color bytes, of 255, that encoding may make. */
const lossy = 4;
/** Pictures of different times differ by more. */
const different = 8;

const page = sharedPage(async (page) => {
  await drawPlainly(page);
  await openBundled(page, 'small');
  await openSmallView(page, 'model=insect');
  await page.evaluate(() => window.sinew.seek(0.25));
});

async function movie(options: Partial<MovieSettings>): Promise<Buffer> {
  return bytesOf(await page().evaluateHandle((options) => window.sinew.movie(options), options));
}

async function captured(options: CaptureOptions = size): Promise<Buffer> {
  return bytesOf(await page().evaluateHandle((options) => window.sinew.capture(options), options));
}

/** The file of a still of a frame, after which the page shows the time from before. */
async function still(frame: number, options: CaptureOptions = size): Promise<Buffer> {
  await page().evaluate((time) => window.sinew.seek(time), timeOf(frame));
  const file = await captured(options);
  await page().evaluate(() => window.sinew.seek(0.25));
  return file;
}

/** The mean difference of colors, or of alpha, over all pixels. */
function meanError(a: Uint8Array, b: Uint8Array, part: 'colors' | 'alpha' = 'colors'): number {
  expect(a.length).toBe(b.length);
  const channels = part === 'colors' ? [0, 1, 2] : [3];
  let sum = 0;
  for (let at = 0; at < a.length; at += 4) {
    for (const channel of channels) sum += Math.abs(a[at + channel]! - b[at + channel]!);
  }
  return sum / ((a.length / 4) * channels.length);
}

test('frames of a PNG sequence are the stills of their times, byte for byte', async () => {
  const before = await captured();
  const objects = await page().evaluate(() => window.sinew.liveObjects);
  const files = unzipSync(await movie({ ...short, format: 'png' }));
  // The page shows what it showed, and holds what it held.
  expect((await captured()).equals(before)).toBe(true);
  expect(await page().evaluate(() => window.sinew.liveObjects)).toEqual(objects);
  expect(Object.keys(files)).toEqual(Array.from({ length: 8 }, (_, at) => `frame-000${at}.png`));
  for (const frame of [0, 3, 7]) {
    const file = Buffer.from(files[`frame-000${frame}.png`]!);
    expect(file.equals(await still(frame)), `frame ${frame}`).toBe(true);
  }
});

test('samples, transparency and a turn of the camera are those of stills', async () => {
  const fine = { samples: 2, background: false } as const;
  const turntable = { turns: true, turnSeconds: 0.4, plays: false } as const;
  const files = unzipSync(await movie({ ...short, ...fine, ...turntable, format: 'png' }));
  expect(Object.keys(files)).toHaveLength(4);
  const shown = await captured({ ...size, ...fine });
  expect(Buffer.from(files['frame-0000.png']!).equals(shown)).toBe(true);
  expect(Buffer.from(files['frame-0001.png']!).equals(shown)).toBe(false);
});

/** The first and the last frame of a video as the page plays it. */
async function played(page: Page, options: Partial<MovieSettings>) {
  const found = await page.evaluateHandle(async (options) => {
    const blob = await window.sinew.movie(options);
    const video = document.createElement('video');
    video.muted = true;
    const loaded = new Promise((resolve, reject) => {
      video.onloadeddata = resolve;
      video.onerror = () => reject(new Error(video.error?.message));
    });
    video.src = URL.createObjectURL(blob);
    await loaded;
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [video.videoWidth, video.videoHeight];
    const context = canvas.getContext('2d', { willReadFrequently: true })!;
    const at = async (time: number) => {
      // A frame that was sought may come to the canvas later than the event says.
      const shown = new Promise((resolve) => video.requestVideoFrameCallback(resolve));
      video.currentTime = time;
      await shown;
      context.clearRect(0, 0, canvas.width, canvas.height);
      context.drawImage(video, 0, 0);
      return context.getImageData(0, 0, canvas.width, canvas.height).data;
    };
    const half = 0.5 / options.rate!;
    const pictures = [await at(half), await at(video.duration - half)];
    URL.revokeObjectURL(video.src);
    return { type: blob.type, duration: video.duration, pictures };
  }, options);
  const pictures = await bytesOf(
    await found.evaluateHandle(
      ({ pictures }) => new Blob(pictures as Uint8ClampedArray<ArrayBuffer>[]),
    ),
  );
  const [first, last] = [0, 1].map((at) => {
    const half = pictures.length / 2;
    return pictures.subarray(at * half, (at + 1) * half);
  });
  const told = await found.evaluate(({ type, duration }) => ({ type, duration }));
  return { ...told, first: first!, last: last! };
}

for (const format of ['webm', 'mp4'] as const) {
  test(`${format} plays back to the stills of its first and last frame`, async () => {
    const isEncoded = await page().evaluate(
      async (codec) =>
        (await VideoEncoder.isConfigSupported({ codec, width: 160, height: 96 })).supported,
      format === 'webm' ? 'vp8' : 'avc1.64000b',
    );
    test.skip(!isEncoded, `this browser encodes no ${format}`);
    const video = await played(page(), { ...short, format });
    expect(video.type).toBe(`video/${format}`);
    expect(video.duration).toBeCloseTo(0.8, 2);
    const [first, last] = [PNG.sync.read(await still(0)).data, PNG.sync.read(await still(7)).data];
    expect(meanError(video.first, first)).toBeLessThan(lossy);
    expect(meanError(video.last, last)).toBeLessThan(lossy);
    expect(meanError(video.first, last)).toBeGreaterThan(different);
  });
}

test('WebM is transparent where a still is', async () => {
  const video = await played(page(), { ...short, format: 'webm', background: false });
  const first = PNG.sync.read(await still(0, { ...size, background: false })).data;
  expect(meanError(video.first, first, 'alpha')).toBeLessThan(1);
  expect(first.filter((byte, at) => at % 4 === 3 && byte === 0).length).toBeGreaterThan(1000);
});

test('GIF has the colors of the stills', async () => {
  const gif = await page().evaluateHandle(
    async (options) => {
      const blob = await window.sinew.movie(options);
      const decoder = new ImageDecoder({ data: await blob.arrayBuffer(), type: blob.type });
      await decoder.tracks.ready;
      const { frameCount, repetitionCount } = decoder.tracks.selectedTrack!;
      const durations: (number | null)[] = [];
      const pictures: Uint8ClampedArray<ArrayBuffer>[] = [];
      for (let frameIndex = 0; frameIndex < frameCount; frameIndex++) {
        const { image } = await decoder.decode({ frameIndex });
        const canvas = new OffscreenCanvas(image.displayWidth, image.displayHeight);
        const context = canvas.getContext('2d')!;
        context.drawImage(image, 0, 0);
        durations.push(image.duration);
        pictures.push(context.getImageData(0, 0, canvas.width, canvas.height).data);
        image.close();
      }
      return { repetitionCount, durations, pictures: new Blob(pictures) };
    },
    { ...short, format: 'gif' } as const,
  );
  const { repetitionCount, durations } = await gif.evaluate((gif) => ({
    ...{ repetitionCount: gif.repetitionCount, durations: gif.durations },
  }));
  expect(repetitionCount).toBe(Infinity);
  expect(durations).toEqual(new Array(8).fill(100_000));
  const pictures = await bytesOf(await gif.evaluateHandle(({ pictures }) => pictures));
  for (const frame of [0, 7]) {
    const each = pictures.length / 8;
    const shown = pictures.subarray(frame * each, (frame + 1) * each);
    expect(meanError(shown, PNG.sync.read(await still(frame)).data)).toBeLessThan(2);
  }
});

// `npm run test:long -- movie` makes 600 frames of 1080p.
const long = Number(process.env['MOVIE_FRAMES'] ?? 30);

test('few frames wait in the encoder, and memory does not grow with the movie', async () => {
  test.setTimeout(long > 60 ? 60 * 60_000 : 90_000);
  const { client, heap } = await heapOf(page());
  const large = long > 60 ? { width: 1920, height: 1080 } : { width: 640, height: 360 };
  const waiting = await page().evaluateHandle(() => {
    const seen = {
      most: 0,
      inWork: 0,
      frames: 0,
      at: null as null | ((frames: number) => unknown),
    };
    const { encode } = VideoEncoder.prototype;
    VideoEncoder.prototype.encode = function (...parameters) {
      encode.apply(this, parameters);
      seen.frames++;
      seen.most = Math.max(seen.most, this.encodeQueueSize);
    };
    return seen;
  });
  const done = page().evaluate(async (options) => (await window.sinew.movie(options)).size, {
    ...large,
    range: 'typed',
    from: 0,
    to: long / 30,
    rate: 30,
    format: 'webm',
  } as const);
  const reached = (frames: number) =>
    expect
      .poll(() => waiting.evaluate((seen) => seen.frames), { timeout: 0 })
      .toBeGreaterThanOrEqual(frames);
  await reached(10);
  const early = await heap();
  await reached(long - 2);
  const late = await heap();
  expect(await done).toBeGreaterThan(1000);
  expect(await waiting.evaluate(({ frames }) => frames)).toBe(long);
  expect(await waiting.evaluate(({ most }) => most)).toBeLessThanOrEqual(8);
  // If the page kept the frames between, it would hold their pixels.
  const kept = (long - 12) * large.width * large.height * 4;
  expect(late - early, 'bytes').toBeLessThanOrEqual(Math.min(0.5 * kept, 20e6));
  await client.detach();
});

/** Measures what scripts and their buffers keep alive, in bytes, after collecting garbage. */
async function heapOf(page: Page) {
  const client = await page.context().newCDPSession(page);
  const heap = async (): Promise<number> => {
    await client.send('HeapProfiler.collectGarbage');
    const { usedSize, backingStorageSize } = (await client.send('Runtime.getHeapUsage')) as {
      readonly usedSize: number;
      readonly backingStorageSize: number;
    };
    return usedSize + backingStorageSize;
  };
  return { client, heap };
}

test.describe('the dialog', () => {
  test.use({ ...coarse, viewport: { width: 960, height: 760 } });

  test('saves by keys, tells what will come, cancels, and says what the browser lacks', async ({
    page,
  }) => {
    test.slow(); // it makes a movie and begins another
    await page.addInitScript(() => {
      const ask = VideoEncoder.isConfigSupported.bind(VideoEncoder);
      VideoEncoder.isConfigSupported = async (config) => ({
        ...(await ask(config)),
        ...(config.codec.startsWith('avc') && { supported: false }),
      });
    });
    await openApp(page, 'model=insect');
    await runByName(page, 'save a movie');
    const dialog = page.getByRole('dialog', { name: 'Save a movie' });
    const format = (name: RegExp) => dialog.getByRole('radio', { name });
    const turn = dialog.getByRole('spinbutton', { name: 'Turn seconds' });
    await expect(format(/MP4/)).toBeDisabled();
    await expect(dialog.getByText('This browser encodes no H.264')).toBeVisible();
    expect(await violations(page, { within: 'dialog' })).toEqual([]);
    await page.emulateMedia({ colorScheme: 'dark' });
    expect(await violations(page, { within: 'dialog', ...onlyColors })).toEqual([]);
    await page.emulateMedia({ colorScheme: 'light' });

    // Everything is reached and set by keys.
    await format(/WebM/).focus();
    await page.keyboard.press('ArrowDown');
    await expect(format(/GIF/)).toBeChecked();
    await dialog.getByLabel('Size').selectOption('Width × height');
    await dialog.getByRole('spinbutton', { name: 'Width pixels' }).fill('96');
    await dialog.getByRole('spinbutton', { name: 'Height pixels' }).fill('64');
    await dialog.getByLabel('Rate').fill('15');
    await dialog.getByLabel('The camera turns once around').press('Space');
    await turn.fill('0.4');
    await expect(dialog.locator('output')).toContainText('6 frames, 0.40 s, 96 × 64 pixels, about');
    const downloading = page.waitForEvent('download');
    await page.keyboard.press('Enter');
    const download = await downloading;
    expect(download.suggestedFilename()).toMatch(/\.gif$/);
    await expect(page.locator('.notice')).toHaveText(/\.gif saved: 6 frames$/);

    // A movie that takes long is canceled, and everything of it is freed.
    await page.evaluate(() => window.sinew.settled());
    const objects = await page.evaluate(() => window.sinew.liveObjects);
    await runByName(page, 'save a movie');
    await format(/WebM/).click();
    await turn.fill('100');
    await page.keyboard.press('Enter');
    await expect(page.locator('.progress')).toContainText(/frame \d+ of 1500/);
    await page.locator('.progress button').click();
    await expect(page.locator('.notice')).toHaveText('Canceled');
    await expect.poll(() => page.evaluate(() => window.sinew.liveObjects)).toEqual(objects);
  });
});

/** Runs a command of the palette, whose field is loaded first. */
async function runByName(page: Page, name: string): Promise<void> {
  await page.keyboard.press('Control+k');
  await expect(page.getByRole('dialog', { name: 'Commands' }).getByRole('combobox')).toBeFocused();
  await page.keyboard.type(name);
  await page.keyboard.press('Enter');
}
