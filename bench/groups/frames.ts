import type { Page } from '@playwright/test';
import { checkPictures } from '../frames/check.ts';
import { frameContender, openPage } from '../frames/contender.ts';
import type { CallCounts } from '../frames/count-calls.ts';
import type { FrameKind } from '../frames/page.ts';
import { launchBrowser } from '../harness/browser.ts';
import { buildPages } from '../harness/build-pages.ts';
import {
  type BenchOptions,
  expectRight,
  type GroupResult,
  timesFaster,
  timesSlower,
  type Value,
} from '../harness/group.ts';
import { type Contender, measure } from '../harness/measure.ts';
import { serve } from '../harness/serve.ts';

const scripts = { sinew: 'frames/sinew.ts', three: 'peers/three-frame.mjs' };
const kinds: readonly FrameKind[] = ['posed', 'camera', 'still'];

/** The sizes of the table: the bundled human's, and a detailed scan's. */
const vertexCounts = { '13k': 13_000, '100k': 100_000 };

/** Frames without a GPU, against three.js; and the redraw of an unchanged pose. */
export async function frames({ rounds }: BenchOptions): Promise<GroupResult> {
  const server = await serve(await buildPages('frames', scripts));
  const browser = await launchBrowser();
  const open = (address: string): Promise<Page> =>
    openPage(browser, `${server.address}/${address}`);
  try {
    const counts: Record<string, number | string> = {};
    const contenders: Contender[] = [];
    const clock = await browser.newBrowserCDPSession();
    const add = (id: string, page: Page, kind: FrameKind): void => {
      contenders.push(frameContender(id, page, kind, clock));
    };
    const shadow = await countFrames(open, counts);
    for (const [size, vertices] of Object.entries(vertexCounts)) {
      const sinew = await open(`sinew.page?vertices=${vertices}`);
      const three = await open(`three.page?vertices=${vertices}&shadow=${shadow}`);
      const plain = await open(`sinew.page?vertices=${vertices}&unskinned`);
      const [covered] = await checkPictures(sinew, three);
      counts[`covered pixels, ${size}`] = covered;
      counts['renderer'] = await sinew.evaluate(() => window.frameBench.renderer);
      for (const kind of kinds) add(`sinew ${kind} ${size}`, sinew, kind);
      add(`three posed ${size}`, three, 'posed');
      add(`three camera ${size}`, three, 'camera');
      add(`sinew unskinned ${size}`, plain, 'still');
    }
    const samples = await measure(contenders, rounds);
    const values: Record<string, Value> = {};
    for (const size of Object.keys(vertexCounts)) {
      for (const kind of ['posed', 'camera']) {
        values[`frame-${kind}-${size}`] = timesFaster(
          samples,
          `sinew ${kind} ${size}`,
          `three ${kind} ${size}`,
        );
      }
      values[`frame-still-${size}`] = timesSlower(
        samples,
        `sinew still ${size}`,
        `sinew unskinned ${size}`,
      );
    }
    return { values, samples, counts };
  } finally {
    await browser.close();
    server.close();
  }
}

/**
 * Counts what frames ask of WebGL, on pages of their own, because counting costs time.
 *
 * @param counts gets what was counted
 * @returns the size of Sinew's shadow map, which the peer's must have too
 */
async function countFrames(
  open: (address: string) => Promise<Page>,
  counts: Record<string, number | string>,
): Promise<number> {
  let shadowSize = 0;
  for (const program of Object.keys(scripts)) {
    const page = await open(`${program}.page?vertices=1000&shadow=${shadowSize}&count`);
    let last: CallCounts | undefined;
    for (const kind of kinds) {
      const found = await page.evaluate((kind) => window.frameBench.count(kind, 1), kind);
      const { samples, shadowSize: size, ...ofFrame } = found;
      for (const [name, count] of Object.entries(ofFrame)) {
        counts[`${program}, ${kind} frame, ${name}`] = count;
      }
      if (kind === 'posed') expectRight(found.otherDraws > 0, `${program} draws no shadow`);
      else if (program === 'sinew') checkIdle(kind, found);
      expectRight(samples === 4, `${program} draws ${samples} samples per pixel`);
      expectRight(
        shadowSize === 0 || size === shadowSize,
        `${program} has a shadow map of ${size}`,
      );
      last = found;
    }
    shadowSize = last!.shadowSize;
    await page.close();
  }
  counts['shadow map'] = shadowSize;
  return shadowSize;
}

/** Without a new pose, the skin and its shadows stay, and nothing is sent. */
function checkIdle(kind: FrameKind, { feedbacks, otherDraws, uploadedBytes }: CallCounts): void {
  const work = [feedbacks, otherDraws, uploadedBytes];
  expectRight(
    work.every((count) => count === 0),
    `a ${kind} frame skins, draws shadows or sends bytes: ${work.join(', ')}`,
  );
}
