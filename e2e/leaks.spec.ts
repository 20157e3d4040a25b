import { expect } from '@playwright/test';
import { drop, openSmallView } from './support/app.ts';
import { countHoldings, type Holdings, holdingsOf } from './support/holdings.ts';
import { madeCharacter } from './support/made-character.ts';
import { sharedPage, test } from './support/test.ts';

const page = sharedPage(async (page) => {
  await countHoldings(page);
  await openSmallView(page, 'model=tube');
});

test('fifty loads and unloads leave nothing behind', async () => {
  test.slow();
  // Two characters by turns: one from its texture, past sixteen influences, one from attributes.
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

test('from a textured character with a clip that plays to another and back, again and again', async () => {
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
  let after = before;
  for (let i = 0; i < 2; i++) after = await round();
  expect(after).toEqual(before);
});

test('large files are read in workers, which end', async () => {
  const made = await page().evaluate(() => window.holdings());
  for (const id of ['human', 'dog']) {
    await page().evaluate((id) => window.sinew.open(id), id);
  }
  expect(await page().evaluate(() => window.holdings())).toEqual(made);
});
