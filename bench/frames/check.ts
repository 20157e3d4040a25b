import type { Page } from '@playwright/test';
import { expectRight } from '../harness/group.ts';

/** The least share of the picture that the body covers. */
const leastCovered = 0.05;
/** How much the covered pixels of two contenders may differ. */
const coverageTolerance = 0.05;
/** A lit body with its shadow on a floor has many times as many colors. */
const leastColors = 100;

/**
 * Checks that two contenders draw the same body in the same poses, from the same direction, and
 * that neither picture is blank.
 *
 * @returns the covered pixels of each in the first pose
 */
export async function checkPictures(a: Page, b: Page): Promise<readonly [number, number]> {
  for (const page of [a, b]) {
    const { colors, error } = await page.evaluate(() => window.frameBench.look());
    expectRight(error === 0, `${nameOf(page)} has the WebGL error ${error}`);
    expectRight(colors >= leastColors, `${nameOf(page)} draws ${colors} colors`);
  }
  let first: readonly [number, number] | undefined;
  for (const pose of [0, 3, 7]) {
    const [left, right] = await Promise.all([silhouette(a, pose), silhouette(b, pose)]);
    const [ofA, ofB] = [covered(left), covered(right)];
    const size = left.length;
    expectRight(ofA > leastCovered * size, `${nameOf(a)} covers ${ofA} of ${size} pixels`);
    const shared = Array.from(left).filter((one, i) => one === '1' && right[i] === '1').length;
    const difference = Math.max(ofA, ofB) - shared;
    expectRight(
      difference <= coverageTolerance * ofA,
      `in pose ${pose} ${nameOf(a)} covers ${ofA} pixels, ${nameOf(b)} ${ofB}, both ${shared}`,
    );
    first ??= [ofA, ofB];
  }
  return first!;
}

function silhouette(page: Page, pose: number): Promise<string> {
  return page.evaluate((index) => window.frameBench.silhouette(index), pose);
}

function covered(pixels: string): number {
  return pixels.length - pixels.replaceAll('1', '').length;
}

function nameOf(page: Page): string {
  return page.url().replace(/^.*\//, '');
}
