import { expect } from '@playwright/test';
import { drop, openSmallView } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { test } from './support/test.ts';

/** What a page holds on to that a leak would let grow. */
interface Holdings {
  readonly objects: Readonly<Record<string, number>>;
  readonly listeners: number;
  readonly workers: number;
  readonly urls: number;
}

declare global {
  interface Window {
    holdings(): Omit<Holdings, 'objects'>;
  }
}

test('fifty loads and unloads leave nothing behind', async ({ page }) => {
  test.slow();
  await page.addInitScript(countHoldings);
  await openSmallView(page, 'model=tube');
  // Two characters by turns: one from its texture, past sixteen influences, one from attributes.
  const characters = [madeCharacter(5, 2), madeCharacter(30, 20)].map((files, index) =>
    files.map((file) => ({ ...file, name: file.name.replace('made', `made${index}`) })),
  );
  const round = async (): Promise<Holdings> => {
    for (const files of characters) await drop(page, files);
    await page.evaluate(() => window.sinew.capture({ width: 64, height: 48 }));
    const objects = await page.evaluate(() => window.sinew.liveObjects);
    return { objects, ...(await page.evaluate(() => window.holdings())) };
  };
  const before = await round();
  let after = before;
  for (let i = 0; i < 24; i++) after = await round();
  expect(after).toEqual(before);
  expect(Object.keys(before.objects).length).toBeGreaterThan(4);
});

test('from a textured character with a clip that plays to another and back, again and again', async ({
  page,
}) => {
  await page.addInitScript(countHoldings);
  await openSmallView(page, 'model=tube');
  const round = async (): Promise<Holdings> => {
    await page.evaluate(async () => {
      await window.sinew.open('tube');
      await window.sinew.open('insect');
      window.sinew.morphs({ insect_breathe: 1 });
      window.sinew.togglePlay();
      await window.sinew.capture({ width: 64, height: 48 });
    });
    const objects = await page.evaluate(() => window.sinew.liveObjects);
    return { objects, ...(await page.evaluate(() => window.holdings())) };
  };
  const before = await round();
  let after = before;
  for (let i = 0; i < 3; i++) after = await round();
  expect(after).toEqual(before);
});

test('large files are read in workers, which end', async ({ page }) => {
  await page.addInitScript(countHoldings);
  await openSmallView(page, 'model=tube');
  const made = await page.evaluate(() => window.holdings());
  for (const id of ['human', 'dog', 'human']) {
    await page.evaluate((id) => window.sinew.open(id), id);
  }
  expect(await page.evaluate(() => window.holdings())).toEqual(made);
});

/** Counts listeners on lasting targets, workers and blob URLs; runs in the page before its scripts. */
function countHoldings(): void {
  const counts = { listeners: 0, workers: 0, urls: 0 };
  const lasting = (target: EventTarget): boolean =>
    target === window || target === document || target instanceof HTMLCanvasElement;
  const { addEventListener, removeEventListener } = EventTarget.prototype;
  EventTarget.prototype.addEventListener = function (this: EventTarget, ...parameters) {
    if (lasting(this)) counts.listeners++;
    addEventListener.apply(this, parameters);
  };
  EventTarget.prototype.removeEventListener = function (this: EventTarget, ...parameters) {
    if (lasting(this)) counts.listeners--;
    removeEventListener.apply(this, parameters);
  };
  window.Worker = class extends Worker {
    constructor(...parameters: ConstructorParameters<typeof Worker>) {
      super(...parameters);
      counts.workers++;
    }
    override terminate(): void {
      counts.workers--;
      super.terminate();
    }
  };
  const { createObjectURL, revokeObjectURL } = URL;
  URL.createObjectURL = (object: Blob) => {
    counts.urls++;
    return createObjectURL(object);
  };
  URL.revokeObjectURL = (url: string) => {
    counts.urls--;
    revokeObjectURL(url);
  };
  window.holdings = () => ({ ...counts });
}
