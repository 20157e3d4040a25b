import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { choose, drop, openSmallView } from './support/app.ts';
import { countHoldings, type Holdings, holdingsOf } from './support/holdings.ts';
import { madeCharacter } from './support/made-character.ts';
import { drawPlainly, openBundled, sharedPage, test } from './support/test.ts';

const page = sharedPage(async (page) => {
  await countHoldings(page);
  await drawPlainly(page);
  await openBundled(page, 'small');
  await openSmallView(page, 'model=tube');
});

test('fifty loads and unloads leave nothing behind', async () => {
  test.slow();
  // The two characters alternate. One has more than sixteen influences and reads them from a
  // texture, the other reads them from attributes.
  const characters = [madeCharacter(5, 2), madeCharacter(30, 20)].map((files, index) =>
    files.map((file) => ({ ...file, name: file.name.replace('made', `made${index}`) })),
  );
  const round = async (): Promise<Holdings> => {
    for (const files of characters) await drop(page(), files);
    await page().evaluate(() => window.sinew.capture({ width: 64, height: 48 }));
    return holdingsOf(page());
  };
  const before = await round();
  let after = before;
  for (let i = 0; i < 24; i++) after = await round();
  expect(after).toEqual(before);
  expect(Object.keys(before.objects).length).toBeGreaterThan(4);
});

test('switching between a textured character with a playing clip and another leaves nothing behind', async () => {
  const round = async (): Promise<Holdings> => {
    await page().evaluate(async () => {
      await window.sinew.open('tube');
      await window.sinew.open('insect');
      window.sinew.morphs({ insect_breathe: 1 });
      window.sinew.togglePlay();
      await window.sinew.capture({ width: 64, height: 48 });
    });
    return holdingsOf(page());
  };
  const before = await round();
  expect(await round()).toEqual(before);
});

test('an image on a character, and weights in color, leave nothing behind', async () => {
  const image = readFileSync('public/data/insect/insect.png');
  const drawn = async (): Promise<Holdings> => {
    await page().evaluate(() => window.sinew.capture({ width: 64, height: 48 }));
    return holdingsOf(page());
  };
  const round = async (): Promise<Holdings> => {
    await page().evaluate(() => window.sinew.open('tube'));
    const bare = await drawn();
    await drop(page(), [{ name: 'cover.png', content: image }]);
    const covered = await drawn();
    expect(covered.objects['texture']).toBeGreaterThan(bare.objects['texture'] ?? 0);
    for (const view of ['All joints', 'Error of the sum', 'Off']) {
      await choose(page(), 'Colors (v)', view);
    }
    await page().evaluate(() => window.sinew.open('hand'));
    return drawn();
  };
  const before = await round();
  expect(await round()).toEqual(before);
});

test('the workers that read large files are terminated', async () => {
  await page().evaluate(() => void (window.bundled = 'whole'));
  const made = await page().evaluate(() => window.holdings());
  for (const id of ['human', 'dog']) {
    await page().evaluate((id) => window.sinew.open(id), id);
  }
  expect(await page().evaluate(() => window.holdings())).toEqual(made);
});
