import { writeFileSync } from 'node:fs';
import { expect, type Page } from '@playwright/test';
import { courseFiles } from '../bench/data/course-files.ts';
import { cylinder } from '../bench/data/cylinder.ts';
import { chooseFromMenu, openApp } from './support/app.ts';
import { expectShortTasks, type LongTask, mainThreadTasks } from './support/main-thread.ts';
import { coarse, test } from './support/test.ts';

// `npm run test:long -- million` opens a character of a million vertices, and measures how long the
// page's main thread is busy meanwhile. The usual size shows that a large character works at all.
test.use({ ...coarse, viewport: { width: 960, height: 420 } });

const vertexCount = Number(process.env['MILLION_VERTICES'] ?? 20_000);
const isLong = vertexCount >= 1_000_000;

test('a very large MIT character opens, poses and orbits', async ({ page }, info) => {
  test.setTimeout(isLong ? 30 * 60_000 : 60_000);
  const body = cylinder({ vertexCount });
  const paths = (['skel', 'obj', 'attach'] as const).map((kind) => {
    const path = info.outputPath(`large.${kind}`);
    writeFileSync(path, courseFiles[kind](body));
    return path;
  });
  const tasks = await mainThreadTasks(page);
  await openApp(page, 'model=tube');

  const opening = await tasks.during(async () => {
    const choosing = page.waitForEvent('filechooser');
    await chooseFromMenu(page, 'Open files');
    await (await choosing).setFiles(paths);
    await page.waitForFunction(
      (count) => window.sinew.characters.some(({ vertexCount }) => vertexCount === count),
      vertexCount,
      { timeout: 0 },
    );
    await page.evaluate(() => window.sinew.settled());
  });
  // The worker that reads ends in the task that begins to show the character.
  const ended = await page.evaluate(() => window.workerEnded);
  const reading = opening.filter(({ start, duration }) => start + duration < ended);
  annotate('while it reads', reading);
  annotate('until it is shown', opening.slice(reading.length));
  expect(await page.evaluate(() => window.sinew.problems)).toEqual([]);

  const before = await middleVertex(page);
  const posing = await tasks.during(async () => {
    await page.evaluate(() => window.sinew.pose({ joints: { '#4': [0, 0, 0.5] } }));
    await page.evaluate(() => window.sinew.settled());
  });
  annotate('a pose', posing);
  const after = await middleVertex(page);
  expect(Math.hypot(...after.map((value, axis) => value - before[axis]!))).toBeGreaterThan(0.01);

  const azimuth = page.getByRole('slider', { name: 'Azimuth' });
  const from = await azimuth.getAttribute('aria-valuenow');
  const orbiting = await tasks.during(async () => {
    await page.locator('canvas.scene').focus();
    for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowLeft');
    await expect(azimuth).not.toHaveAttribute('aria-valuenow', from!);
    await page.evaluate(() => window.sinew.settled());
  });
  annotate('orbiting', orbiting);
  if (isLong) expectShortTasks(reading, 100);
});

/** A posed vertex halfway up the body. */
function middleVertex(page: Page): Promise<number[]> {
  return page.evaluate(() => {
    const positions = window.sinew.vertices('gpu');
    const at = 3 * Math.floor(positions.length / 6);
    return [...positions.slice(at, at + 3)];
  });
}

function annotate(when: string, found: readonly LongTask[]): void {
  const description = found.map(({ duration }) => `${Math.round(duration)} ms`).join(', ');
  test.info().annotations.push({
    type: `main-thread tasks over 50 ms, ${when}`,
    description: description || 'none',
  });
}
