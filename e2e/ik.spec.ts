import { expect, type Page } from '@playwright/test';
import { poseFromJson } from '../src/formats/pose-json.ts';
import { presentAngles } from '../src/posing/natural/natural-skeleton.ts';
import { naturesOf } from '../src/posing/natural/natures.ts';
import { readBundled } from '../tests/support/bundled.ts';
import { controlRow, openApp } from './support/app.ts';
import { violations } from './support/axe.ts';
import { typeNumber } from './support/controls.ts';
import { find, type Place } from './support/find-limb.ts';
import { coarse, openBundled, sharedPage, test } from './support/test.ts';

test.use({ ...coarse, viewport: { width: 1000, height: 500 }, hasTouch: true });
let hand: Place;
const page = sharedPage(async (page) => {
  // The places of limbs are searched for in steps of some pixels.
  await openBundled(page, 'whole');
  await openApp(page, 'model=human');
  const box = (await page.locator('canvas.scene').boundingBox())!;
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

test('natural joints keep the elbow in its plane, with ranges to edit', async () => {
  const character = await readBundled('human');
  const { skeleton } = character;
  const elbow = skeleton.names.indexOf('Left forearm');
  const nature = naturesOf(character).find(({ joint }) => joint === elbow)!;
  const before = await pose();
  /** Drags the hand, and returns how far the elbow is bent sideways, in degrees. */
  const draggedSide = async (): Promise<number> => {
    await page().mouse.move(hand.x, hand.y);
    await page().mouse.down();
    await page().mouse.move(hand.x - 60, hand.y + 50, { steps: 2 });
    // The pose follows from picture to picture, until it rests.
    let last: string;
    do {
      last = await pose();
      await page().waitForTimeout(300);
    } while (last !== (await pose()));
    await page().mouse.up();
    const { value } = poseFromJson('pose', JSON.parse(await pose()), skeleton);
    await page().keyboard.press('Control+z');
    expect(await pose()).toBe(before);
    return (Math.abs(presentAngles(skeleton, nature, value!.q)[1]) * 180) / Math.PI;
  };
  const natural = controlRow(page(), 'Natural joints').locator('input');
  await page().keyboard.press('i');
  const kept = await draggedSide();
  await natural.dispatchEvent('click');
  await expect(natural).not.toBeChecked();
  const free = await draggedSide();
  // The range is soft: how near the elbow comes to it depends on the pictures that the drag had.
  expect(free).toBeGreaterThan(5);
  expect(kept).toBeLessThan(free / 2);
  await page().keyboard.press('Control+z');
  await expect(natural).toBeChecked();

  const most = page().locator('input[aria-label="Left hand bend to"]');
  const found = await most.inputValue();
  await typeNumber(page(), 'Left hand bend to', 0.5);
  await expect(most).toHaveValue('0.500');
  await page()
    .getByRole('button', { name: 'Reset ranges', includeHidden: true })
    .dispatchEvent('click');
  await expect(most).toHaveValue(found);
  await page().keyboard.press('Control+z');
  await expect(most).toHaveValue('0.500');
  await page().keyboard.press('Control+z');
  await expect(most).toHaveValue(found);

  const section = page().locator(
    '.controls .lil-gui:has(> .lil-title:text-is("Inverse kinematics"))',
  );
  for (const title of await section.locator('.lil-title').all()) {
    if ((await title.getAttribute('aria-expanded')) !== 'true') await title.dispatchEvent('click');
  }
  await expect(most).toBeVisible();
  expect(await violations(page(), { within: '[data-section=ik]' })).toEqual([]);
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
