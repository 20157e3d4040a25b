import { expect } from '@playwright/test';
import { openApp, openTab } from './support/app.ts';
import type { Place } from './support/find-limb.ts';
import { coarse, sharedPage, test } from './support/test.ts';
import { touchUser } from './support/touch-user.ts';

// The timeline and the curves by fingers alone, on a phone.
test.use({ ...coarse, viewport: { width: 390, height: 844 }, hasTouch: true });
const page = sharedPage(async (page) => {
  await openApp(page, 'model=insect');
  await openTab(page, 'animate');
  await expect(page.locator('.dope canvas')).toBeVisible();
});

const timeline = () => page().getByRole('region', { name: 'Timeline' });
const menu = () => page().getByRole('menu', { name: 'Selected keys' });
const undo = () => page().locator('.top [data-command=undo]');
const labels = () => timeline().locator('.marks .labeled').allTextContents();

/** A place of a canvas, from 0 to 1 across it, and so many pixels from its top. */
async function placeIn(canvas: string, part: number, down: number): Promise<Place> {
  const { x, y, width } = (await timeline().locator(canvas).boundingBox())!;
  return { x: x + part * width, y: y + down };
}

/** The key of all rows at 0 s, which the timeline frames with a little room before it. */
const firstKey = () => placeIn('.dope canvas', 0.16 / 4.32, 22);

test('a tap selects keys, a long press opens their menu, and fingers move what is shown', async () => {
  const user = await touchUser(page());
  await user.tap(await firstKey());
  await expect(timeline().getByRole('treegrid').locator('[tabindex="0"]')).toContainText('All');
  await user.press(await firstKey(), () => expect(menu()).toBeVisible());
  await user.tap(menu().getByRole('menuitem', { name: 'Stepped' }));
  await expect(undo()).toHaveAttribute('title', /stepped/);
  await user.tap(undo());
  await expect(undo()).toBeDisabled();

  const before = await labels();
  await user.pinch(await placeIn('.dope canvas', 0.5, 60), 60, 180);
  await expect.poll(labels).not.toEqual(before);
  const nearer = await labels();
  await user.stroke(await placeIn('.dope canvas', 0.8, 60), -100, 0);
  await expect.poll(labels).not.toEqual(nearer);
  await expect(undo()).toBeDisabled();
  await user.tap(timeline().getByRole('button', { name: 'More' }));
  await user.tap(page().getByRole('menuitem', { name: 'Frame the clip' }));
  await expect.poll(labels).toEqual(before);
});

test('curves are pinched, and continued by the menu of a long press', async () => {
  const user = await touchUser(page());
  await user.tap(timeline().getByRole('button', { name: 'Curves', exact: true }));
  await page().locator('.plot canvas').waitFor();
  const before = await labels();
  await user.pinch(await placeIn('.plot canvas', 0.5, 60), 60, 180);
  await expect.poll(labels).not.toEqual(before);
  await user.press(await placeIn('.plot canvas', 0.9, 10), () => expect(menu()).toBeVisible());
  const after = menu().getByRole('group', { name: 'After the last key' });
  await user.tap(after.getByRole('menuitemradio', { name: 'bounce' }));
  await expect(undo()).toHaveAttribute('title', /Continue after the keys: bounce/);
  await expect(menu()).toBeHidden();
  await user.tap(undo());
  await expect(undo()).toBeDisabled();
  await page().evaluate(() => window.sinew.seek(0.37));
  await user.tap(timeline().locator('[data-command=insert-curve-key]'));
  await expect(undo()).toHaveAttribute('title', /Insert a key/);
  await user.tap(undo());
});

test('a tab of the phone opens the timeline first, then its sheet, then neither', async () => {
  const user = await touchUser(page());
  const animate = page().locator('.phone').getByRole('tab', { name: 'Animate' });
  const curves = timeline().getByRole('button', { name: 'Curves', exact: true });
  const joint = page().getByRole('button', { name: 'Next joint' });
  await user.tap(page().locator('.phone').getByRole('tab', { name: 'Pose' }));
  await expect(joint).toBeInViewport();
  await user.tap(animate);
  await expect(joint).toBeHidden();
  await expect(curves).toBeInViewport();
  await expect(animate).toHaveAttribute('aria-selected', 'true');
  await user.tap(animate);
  await expect(joint).toBeInViewport();
  await expect(curves).toBeHidden();
  await user.tap(animate);
  await expect(curves).toBeInViewport();
});

test('a motion that is pasted as text becomes a clip of the character', async () => {
  const motion = {
    version: 1,
    channels: [
      {
        target: { joint: 'head', value: 'rx' },
        keys: [
          [0, 0],
          [1, 0.5],
        ],
      },
    ],
  };
  await page().evaluate((text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', text);
    window.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
  }, JSON.stringify(motion));
  await expect(page().locator('.notice')).toHaveText('Motion pasted opened: 1 channel, 1 s');
  expect(await page().evaluate(() => window.sinew.clips)).toEqual(['insect_walk', 'pasted']);
  await page().evaluate(() => window.sinew.seek(1));
  expect(await page().evaluate(() => window.sinew.pose().joints?.['head']?.[0])).toBe(0.5);
});
