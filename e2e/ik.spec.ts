import { expect, type Page } from '@playwright/test';
import { openApp } from './support/app.ts';
import { find, type Place } from './support/find-limb.ts';
import { sharedPage, test } from './support/test.ts';

test.use({ viewport: { width: 1000, height: 500 }, hasTouch: true });
let hand: Place;
const page = sharedPage(async (page) => {
  await openApp(page, 'model=human');
  const box = (await page.locator('canvas').boundingBox())!;
  const [from, to] = [0, 1].map((part) => ({
    x: Math.round(box.x + box.width * (0.5 + 0.3 * part)),
    y: Math.round(box.y + box.height * (0.15 + 0.3 * part)),
  }));
  hand = await find(page, from!, to!, 6, { limb: 'Left hand' });
  await page.mouse.click(hand.x, hand.y);
});

const pose = (): Promise<string> => page().evaluate(() => JSON.stringify(window.sinew.pose()));
const text = (): ReturnType<Page['locator']> => page().locator('.active-dof');
/** The values of the joints above the hand. */
const arm = (): Promise<unknown[]> =>
  page().evaluate(() => {
    const { joints } = window.sinew.pose();
    return [joints?.['Left upper arm'], joints?.['Left forearm']];
  });

test('a drag moves the arm, says when it is out of reach, and is one step of undo', async () => {
  const before = await pose();
  const armBefore = await arm();
  await page().keyboard.press('i');
  await page().mouse.move(hand.x, hand.y);
  await page().mouse.down();
  await page().mouse.move(hand.x - 20, hand.y - 20, { steps: 3 });
  await expect(text()).toContainText('Left hand · 4 joints · wheel');
  await page().mouse.wheel(0, -120);
  await expect(text()).toContainText('5 joints');
  // Beyond the view's edge too.
  await page().mouse.move(hand.x + 250, 2, { steps: 3 });
  await expect(text()).toContainText('short of the pointer');
  await page().keyboard.press('Escape');
  expect(await pose()).toBe(before);
  await page().mouse.up();
  await page().mouse.move(hand.x, hand.y);
  await page().mouse.down();
  await page().mouse.move(hand.x - 20, hand.y - 20, { steps: 3 });
  await page().mouse.up();
  expect(await arm()).not.toEqual(armBefore);
  await page().keyboard.press('Control+z');
  expect(await pose()).toBe(before);
  await page().keyboard.press('i');
});

test('arrow keys move the target, and a live region says where the joint is', async () => {
  const before = await pose();
  await page().keyboard.press('i');
  await page().keyboard.press('ArrowUp');
  await expect(page().locator('.status .notice')).toHaveText(/^Left hand at [−-]?\d/);
  const moved = await pose();
  expect(moved).not.toBe(before);
  await page().keyboard.press('Shift+PageUp');
  await expect.poll(pose).not.toBe(moved);
  await page().keyboard.press('Control+z');
  await page().keyboard.press('Control+z');
  expect(await pose()).toBe(before);
  await page().keyboard.press('i');
});

test('a finger drags the target', async () => {
  const before = await pose();
  await page().locator('[data-command=ik-mode]').first().tap();
  const user = await page().context().newCDPSession(page());
  const touch = (type: string, x: number, y: number): Promise<unknown> =>
    user.send('Input.dispatchTouchEvent', {
      type: type as 'touchStart',
      touchPoints: type === 'touchEnd' ? [] : [{ x, y }],
    });
  await touch('touchStart', hand.x, hand.y);
  for (let i = 1; i <= 4; i++) await touch('touchMove', hand.x - 6 * i, hand.y - 6 * i);
  await expect(text()).toContainText('Left hand');
  await touch('touchEnd', 0, 0);
  await expect.poll(pose).not.toBe(before);
  await page().keyboard.press('Control+z');
  expect(await pose()).toBe(before);
});
