import { expect } from '@playwright/test';
import { capture, getPose, openApp, openJoint, startOver } from './support/app.ts';
import { find, type Over, type Place } from './support/find-limb.ts';
import { coarse, sharedPage, test } from './support/test.ts';

// The pointer needs no mode: a click selects a limb, a drag on the selected limb or on one of its
// rings poses, and every other drag is the camera's.
// A small view is drawn faster.
test.use({ ...coarse, viewport: { width: 760, height: 400 } });
const page = sharedPage((page) => openApp(page, 'model=human'));

const canvas = () => page().locator('canvas.scene');
const label = () => page().locator('.lit-bone strong');
const active = () => page().locator('.active-dof');
const selected = () => page().locator('[role=treeitem][aria-selected=true]');
const undo = () => page().getByRole('button', { name: 'Undo' });

/** A point of the view, as fractions of its width and height. */
async function placeAt(across: number, down: number): Promise<Place> {
  const { x, y, width, height } = (await canvas().boundingBox())!;
  return { x: x + across * width, y: y + down * height };
}

async function over({ x, y }: Place): Promise<Over> {
  await page().mouse.move(x, y);
  await page().evaluate(() => new Promise((resolve) => requestAnimationFrame(resolve)));
  const limb = (await label().allTextContents()).join().split(' → ')[0]!;
  return { limb, cursor: await canvas().evaluate((element) => getComputedStyle(element).cursor) };
}

async function findLimb(limb: string, from: Place): Promise<Place> {
  return find(page(), await placeAt(from.x, from.y), await placeAt(0.75, 0.8), 10, { limb });
}

/**
 * A place on one of the three inner rings of the selected joint, near one on its limb: what poses and
 * is no limb.
 */
function findRing({ x, y }: Place, step = 5, reach = 45): Promise<Place> {
  const [from, to] = [
    { x: x - reach, y: y - reach },
    { x: x + reach, y: y + reach },
  ];
  return find(page(), from, to, step, { limb: '', cursor: 'move' });
}

/** What the camera shows of a pose; rings and highlights are not in it. */
const picture = () => capture(page());

async function press({ x, y }: Place): Promise<void> {
  await page().mouse.move(x, y);
  await page().mouse.down();
}

async function click(place: Place): Promise<void> {
  await press(place);
  await page().mouse.up();
}

async function drag(from: Place, right: number, down: number): Promise<Place> {
  const to = { x: from.x + right, y: from.y + down };
  await press(from);
  await page().mouse.move(from.x + right / 2, from.y + down / 2);
  await page().mouse.move(to.x, to.y);
  return to;
}

type Pose = Awaited<ReturnType<typeof getPose>>;

/** The values that differ, by joint. */
function changes(before: Pose, after: Pose): Record<string, number[]> {
  const names = new Set([...Object.keys(before.joints!), ...Object.keys(after.joints!)]);
  const found: Record<string, number[]> = {};
  for (const name of names) {
    const [old, now] = [before, after].map((pose) => pose.joints![name] ?? [0, 0, 0]);
    const changed = now!.flatMap((value, i) => (value === old![i] ? [] : i));
    if (changed.length > 0) found[name] = changed;
  }
  return found;
}

test('the cursor shows what a drag will do, and a drag on another limb is the camera’s', async () => {
  const other = await findLimb('Right lower leg', { x: 0.36, y: 0.66 });
  expect((await over(other)).cursor).toBe('pointer');
  expect((await over(await placeAt(0.02, 0.5))).cursor).toBe('grab');
  const own = await findLimb('Left forearm', { x: 0.45, y: 0.12 });
  await click(own);
  expect((await over(own)).cursor).toBe('move');
  const [pose, before] = [await getPose(page()), await picture()];
  await drag(other, 25, 0);
  await page().mouse.up();
  expect(await getPose(page())).toEqual(pose);
  expect(before.equals(await picture())).toBe(false);
  await expect(selected(), 'a drag selects nothing').toHaveText(/Left forearm/);
  await page().keyboard.press('Space');
});

test('a ring turns one value; Shift is fine, Ctrl snaps; it is one step of undo, and Escape restores the bits', async () => {
  const limb = await findLimb('Left upper arm', { x: 0.45, y: 0.25 });
  await click(limb);
  const pose = await getPose(page());
  const before = await picture();
  const from = await findRing(limb);
  const to = await drag(from, 24, 30);
  const turned = await getPose(page());
  const [[joint, axes]] = Object.entries(changes(pose, turned)) as [[string, number[]]];
  expect([joint, axes.length], 'one value of the selected joint').toEqual(['Left upper arm', 1]);
  const axis = axes[0]!;
  const valueIn = ({ joints }: Pose): number => joints!['Left upper arm']![axis]!;
  await expect(active()).toContainText(`Left upper arm ${'XYZ'[axis]!}`);
  await expect(active()).toContainText(valueIn(turned).toFixed(3));
  await page().mouse.move(from.x, from.y);
  expect(await getPose(page()), 'the way back is the pose of the start').toEqual(pose);
  await page().mouse.move(to.x, to.y);
  await page().keyboard.press('Escape');
  expect(await getPose(page()), 'canceled').toEqual(pose);
  await page().mouse.move(to.x + 9, to.y);
  expect(await getPose(page()), 'and stays so until the button is released').toEqual(pose);
  await page().mouse.up();

  await page().keyboard.down('Shift');
  await drag(from, 24, 30);
  await page().mouse.up();
  await page().keyboard.up('Shift');
  const ratio =
    (valueIn(await getPose(page())) - valueIn(pose)) / (valueIn(turned) - valueIn(pose));
  expect(ratio).toBeCloseTo(0.1, 6);
  await undo().click();
  expect(await getPose(page()), 'one step of undo').toEqual(pose);

  await page().keyboard.down('Control');
  await drag(from, 24, 30);
  await page().mouse.up();
  await page().keyboard.up('Control');
  const steps = valueIn(await getPose(page())) / (Math.PI / 12);
  expect(Math.abs(steps - Math.round(steps))).toBeLessThan(1e-9);
  await undo().click();
  expect(await getPose(page())).toEqual(pose);

  // A ring chooses no value for later drags: the limb turns freely.
  await drag(limb, 24, 30);
  await page().mouse.up();
  const free = Object.values(changes(pose, await getPose(page())));
  expect(free[0]!.length).toBeGreaterThan(1);
  await undo().click();
  expect(before.equals(await picture()), 'the camera rested').toBe(true);
});

test('saved pictures show neither rings nor the light on a limb', async () => {
  await page().keyboard.press('Escape');
  const place = await findLimb('Left upper arm', { x: 0.45, y: 0.25 });
  await click(place);
  await expect(selected()).toHaveText(/Left upper arm/);
  const shown = await canvas().screenshot();
  const saved = await capture(page());
  await click(await placeAt(0.02, 0.75));
  await expect(selected(), 'a click beside all limbs deselects').toHaveCount(0);
  await over(await placeAt(0.02, 0.75));
  expect(saved.equals(await capture(page()))).toBe(true);
  expect(shown.equals(await canvas().screenshot()), 'but the view does').toBe(false);
});

test('a ring stops at the limits of its value, and nothing is highlighted while a clip plays', async () => {
  await page().evaluate(() => window.sinew.open('insect'));
  const head = await findLimb('head', { x: 0.25, y: 0.36 });
  await click(head);
  const before = await getPose(page());
  // The joint is behind the face, so that its inner rings are there.
  const from = await findRing({ x: head.x + 25, y: head.y });
  await press(from);
  const name = (await active().textContent())!;
  const axis = 'XYZ'.indexOf(/head ([XYZ])/.exec(name)![1]!);
  const { slider } = await openJoint(page(), 'head', 'XYZ'[axis]!);
  const limits = await Promise.all(
    ['aria-valuemin', 'aria-valuemax'].map(async (each) => Number(await slider.getAttribute(each))),
  );
  const reached: number[] = [];
  for (const [right, down] of [
    [60, 60],
    [-60, 160],
    [-150, 60],
    [-60, -60],
    [60, 60],
  ] as const) {
    await page().mouse.move(from.x + right, from.y + down);
    const value = (await getPose(page())).joints!['head']?.[axis] ?? 0;
    reached.push(value);
    expect(value).toBeGreaterThanOrEqual(limits[0]! - 1e-3);
    expect(value).toBeLessThanOrEqual(limits[1]! + 1e-3);
  }
  await page().mouse.up();
  expect(Object.keys(changes(before, await getPose(page())))).toEqual(['head']);
  const atLimit = (value: number) => limits.some((limit) => Math.abs(value - limit) < 2e-3);
  expect(reached.some(atLimit), 'it was dragged to a limit').toBe(true);

  await page().evaluate(() => window.sinew.togglePlay());
  expect(await over({ x: head.x + 1, y: head.y })).toEqual({ limb: '', cursor: 'grab' });
  await page().evaluate(() => window.sinew.togglePlay());
});

test('in the Mannequin workspace only bone mode poses', async () => {
  await startOver(page(), 'mannequin');
  const place = await findLimb('Left upper leg', { x: 0.3, y: 0.55 });
  await click(place);
  await expect(selected()).toHaveText(/Left upper leg/);
  expect((await over(place)).cursor).toBe('pointer');
  await expect(findRing(place, 26, 80), 'there are no rings').rejects.toThrow(
    'nothing in the view',
  );
  const [pose, before] = [await getPose(page()), await picture()];
  await drag(place, 20, -10);
  await page().mouse.up();
  expect(await getPose(page())).toEqual(pose);
  expect(before.equals(await picture())).toBe(false);
  await page().keyboard.press('Space');
  await page().keyboard.press('m');
  await drag(place, 12, -8);
  await page().mouse.up();
  expect(Object.keys(changes(pose, await getPose(page())))).toEqual(['Left upper leg']);
});

test.describe('touch', () => {
  test.use({ hasTouch: true });

  test('a tap selects, and one finger on the selected limb poses', async ({ page: own }) => {
    await openApp(own, 'model=human');
    const client = await own.context().newCDPSession(own);
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: Place[]) =>
      client.send('Input.dispatchTouchEvent', {
        type,
        touchPoints: points.map(({ x, y }) => ({ x, y, id: 0 })),
      });
    const stroke = async (from: Place, right: number, down: number): Promise<void> => {
      await touch('touchStart', [from]);
      await touch('touchMove', [{ x: from.x + right / 2, y: from.y + down / 2 }]);
      await touch('touchMove', [{ x: from.x + right, y: from.y + down }]);
      await touch('touchEnd', []);
    };
    const pose = await getPose(own);
    const { x, y, width, height } = (await own.locator('canvas.scene').boundingBox())!;
    const [from, to] = [
      { x: x + 0.36 * width, y: y + 0.62 * height },
      { x: x + 0.7 * width, y: y + 0.7 * height },
    ];
    const limb = 'Right lower leg';
    const shin = await find(own, from, to, 12, { limb });
    await stroke(shin, 14, 0);
    expect(await getPose(own), 'the first stroke is the camera’s').toEqual(pose);
    await stroke(shin, -14, 0);
    await own.touchscreen.tap(shin.x, shin.y);
    await expect(own.locator('[role=treeitem][aria-selected=true]')).toHaveText(new RegExp(limb));
    await stroke(shin, -8, 20);
    expect(Object.keys(changes(pose, await getPose(own)))).toEqual([limb]);
  });
});
