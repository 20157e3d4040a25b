import { expect, type Locator } from '@playwright/test';
import { openApp, startOver } from './support/app.ts';
import { violations } from './support/axe.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use({ ...coarse, viewport: { width: 1000, height: 560 } });
const page = sharedPage((page) => openApp(page, 'model=human'));

const library = (): Locator => page().locator('.poses');
const card = (name: string): Locator => library().getByRole('button', { name, exact: true });
const slider = (): Locator => library().getByRole('slider');
const pose = () => page().evaluate(() => window.sinew.pose());
const undo = () => page().keyboard.press('Control+z');
const status = (): Locator => page().locator('.status');

test('poses are applied, blended, kept, renamed, undone and kept over a reload', async () => {
  await startOver(page());
  const before = await pose();
  await expect(library().locator('li')).toHaveCount(8);

  await card('Sit').click();
  await expect(card('Sit')).toHaveAttribute('aria-pressed', 'true');
  const sitting = await pose();
  expect(sitting.root![1]).toBeLessThan(-0.2);

  // The slider goes back to what was shown before, by keys here, each of which is a step.
  await slider().focus();
  await page().keyboard.press('Home');
  expect(await pose()).toEqual(before);
  await page().keyboard.press('End');
  expect(await pose()).toEqual(sitting);
  for (let i = 0; i < 5; i++) await page().keyboard.press('PageDown');
  await expect(status()).toContainText('Sit 50 %');
  expect((await pose()).root![1]).toBeCloseTo((sitting.root![1] + before.root![1]) / 2, 9);
  for (let i = 0; i < 5; i++) await undo();
  await expect(slider()).toHaveValue('100');

  await card('Wave').click();
  await page().getByRole('treeitem', { name: 'Right upper arm', exact: true }).click();
  await library().getByRole('button', { name: 'Branch' }).click();
  const field = library().getByRole('textbox', { name: 'Name of the pose' });
  await field.fill('Waving arm');
  await field.press('Enter');
  await expect(card('Waving arm')).toHaveAttribute('aria-pressed', 'true');
  // Its picture is drawn: some pixels of it are not transparent.
  const drawn = (): Promise<number> =>
    card('Waving arm')
      .locator('canvas')
      .evaluate((canvas: HTMLCanvasElement) => {
        const { width, height } = canvas;
        const { data } = canvas.getContext('2d')!.getImageData(0, 0, width, height);
        return data.filter((value, i) => i % 4 === 3 && value > 0).length / (width * height);
      });
  await expect.poll(drawn).toBeGreaterThan(0.1);
  expect(await violations(page(), { within: '.poses' })).toEqual([]);

  await card('Think').click();
  await card('Waving arm').click();
  const waving = await pose();
  await card('Think').click();
  const thinking = await pose();
  expect(waving.joints!['Left forearm']).toEqual(thinking.joints!['Left forearm']);
  expect(waving.joints!['Right forearm']).not.toEqual(thinking.joints!['Right forearm']);

  await card('Waving arm').click();
  await library().getByRole('button', { name: 'Mirrored' }).click();
  await expect(status()).toContainText('mirrored');
  const both = (await pose()).joints!;
  expect(both['Left forearm']![0]).toBeCloseTo(waving.joints!['Right forearm']![0], 6);
  expect(both['Left forearm']![1]).toBeCloseTo(-waving.joints!['Right forearm']![1], 6);

  await library()
    .getByRole('button', { name: /^Remove/ })
    .click();
  await expect(card('Waving arm')).toHaveCount(0);
  await undo();
  await expect(card('Waving arm')).toBeVisible();
  await expect(page().locator('.status .kept')).toHaveAttribute('data-keeping', 'kept');
  await page().reload();
  await expect(card('Waving arm')).toBeVisible();
});
