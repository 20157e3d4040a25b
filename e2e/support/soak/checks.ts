import { expect, type CDPSession, type Page } from '@playwright/test';
import { type Holdings, holdingsOf } from '../holdings.ts';

/** Undoing more steps than this would take longer than making them. */
const mostUndone = 10;

/** Ends whatever is in progress: dialogs, playing clips, openings, decoding. */
export async function comeToRest(page: Page): Promise<void> {
  await page.setViewportSize({ width: 760, height: 420 });
  await page.keyboard.press('Escape');
  await page.evaluate(async () => {
    document.querySelector('dialog')?.close();
    (document.activeElement as HTMLElement | null)?.blur();
    await window.sinew.settled();
    const button = (name: string) =>
      document.querySelector<HTMLButtonElement>(`.timeline button[aria-label^="${name}"]`);
    for (const { id } of window.sinew.characters) {
      window.sinew.select(id);
      await new Promise((resolve) => setTimeout(resolve));
      // Pause would bind a clip to an actor that has none bound.
      if (button('Release the clip')?.disabled === false) button('Pause')?.click();
    }
  });
}

/**
 * Expects the CPU and the GPU to agree on the numbers of every character, and one character to be
 * selected.
 */
export async function expectNumbers(page: Page): Promise<void> {
  await expect.poll(() => page.locator('.message').count(), 'the context is back').toBe(0);
  const characters = await page.evaluate(() => window.sinew.characters);
  expect(characters.filter(({ selected }) => selected).length).toBe(Math.min(1, characters.length));
  for (const { id } of characters) {
    expect(await page.evaluate((id) => window.sinew.verify(id), id)).toMatchObject({
      identical: true,
    });
  }
}

/** Expects undo and redo to pass through exactly the same states. */
export async function expectReplay(page: Page): Promise<void> {
  const { undone, redone } = await page.evaluate(async (mostUndone) => {
    const hash = (numbers: Float32Array): number =>
      new Int32Array(numbers.buffer).reduce((sum, bits) => (Math.imul(sum, 31) + bits) | 0, 0);
    /**
     * Everything that scripts can read of the scene, and the places and options that its controls
     * show. Those of inverse kinematics, ghosts, playing and the shown shot belong to the session, and
     * come with a character or a shot.
     */
    const tell = (): string =>
      JSON.stringify(
        window.sinew.characters.map(({ id, name }) => {
          window.sinew.select(id);
          const fields = document.querySelectorAll<HTMLInputElement | HTMLSelectElement>(
            '.controls input[aria-label^="Place "], [data-section]:not([data-section="ik"], [data-section="motion"], [data-section="shots"], [data-section="timeline"]) select',
          );
          return {
            id,
            name,
            pose: window.sinew.pose(undefined, id),
            morphs: window.sinew.morphs({}, id),
            vertices: hash(window.sinew.vertices('cpu', id)),
            fields: [...fields].map(({ value }) => value),
          };
        }),
      );
    const step = async (name: 'Undo' | 'Redo'): Promise<boolean> => {
      const id = name.toLowerCase();
      const button = document.querySelector<HTMLButtonElement>(`.top [data-command="${id}"]`)!;
      if (button.disabled) return false;
      button.click();
      await new Promise((resolve) => setTimeout(resolve));
      return true;
    };
    const undone = [tell()];
    while (undone.length <= mostUndone && (await step('Undo'))) undone.push(tell());
    const redone = [undone.at(-1)!];
    while (redone.length < undone.length && (await step('Redo'))) redone.push(tell());
    return { undone, redone };
  }, mostUndone);
  expect(redone.reverse()).toEqual(undone);
}

export interface Resting extends Holdings {
  /** Nodes of all documents, including detached nodes that something still references. */
  readonly nodes: number;
  /** In bytes. */
  readonly heap: number;
}

/** Measures what the page holds when it shows only a small character. */
export async function restingHoldings(page: Page, devtools: CDPSession): Promise<Resting> {
  await page.evaluate(async () => {
    while (window.sinew.characters.length > 1) window.sinew.remove();
    await window.sinew.open('tube');
    await window.sinew.capture({ width: 64, height: 48 });
  });
  const holdings = await holdingsOf(page);
  await devtools.send('HeapProfiler.collectGarbage');
  const { metrics } = await devtools.send('Performance.getMetrics');
  const metric = (name: string): number => metrics.find((each) => each.name === name)!.value;
  return { ...holdings, nodes: metric('Nodes'), heap: metric('JSHeapUsedSize') };
}

/**
 * The bounds are about twice what a page holds at most with every pass and panel in use, however
 * long it is used. A character that leaked would exceed them after a few openings.
 *
 * @param recentDownloads number of files that were just saved, whose addresses still exist
 */
export function expectNoLeak(resting: Resting, recentDownloads: number): void {
  const { objects, listeners, workers, urls, nodes, heap } = resting;
  const objectCount = Object.values(objects).reduce((sum, count) => sum + count, 0);
  expect(objectCount, JSON.stringify(objects)).toBeLessThan(120);
  expect(listeners, 'listeners on the window, the document and the canvas').toBeLessThan(60);
  expect(workers, 'workers').toBe(0);
  expect(urls, 'addresses of objects').toBeLessThanOrEqual(recentDownloads);
  expect(nodes, 'nodes, in the page and out of it').toBeLessThan(4000);
  expect(heap, 'bytes of the JavaScript heap').toBeLessThan(64e6);
}
