import { expect, type Locator } from '@playwright/test';
import { getPose, openApp, openView } from './support/app.ts';
import { violations } from './support/axe.ts';
import { find, type Place } from './support/find-limb.ts';
import { expectPicture } from './support/pictures.ts';
import { drawPlainly, openBundled, sharedPage, test } from './support/test.ts';

// Rings about a joint's own axes, the scene's and the line of sight; several joints at once; posing
// by keys alone; and the list of steps.
test.use({ viewport: { width: 1000, height: 500 } });
const page = sharedPage(async (page) => {
  await drawPlainly(page);
  await openBundled(page, 'small');
  await openApp(page, 'model=human');
});

const row = (name: string): Locator => page().getByRole('treeitem', { name, exact: true });
const selected = (): Locator => page().locator('[role=treeitem][aria-selected=true]');
const spoken = (): Locator => page().locator('.spoken');
const steps = (): Locator => page().locator('.history li button');
const history = (): Locator => page().locator('.history [aria-current=step]');

type Pose = Awaited<ReturnType<typeof getPose>>;

/** How much each value differs, by joint; joints that stay are left out. */
function changes(before: Pose, after: Pose): Record<string, number[]> {
  const found: Record<string, number[]> = {};
  for (const name of new Set([before, after].flatMap(({ joints }) => Object.keys(joints!)))) {
    const [old, now] = [before, after].map((pose) => pose.joints![name] ?? [0, 0, 0]);
    const change = now!.map((value, i) => value - old![i]!);
    if (change.some((each) => each !== 0)) found[name] = change;
  }
  return found;
}

/** A place of the view where something poses and is no limb: a ring. */
function findRing(from: Place, to: Place, step: number): Promise<Place> {
  return find(page(), from, to, step, { limb: '', cursor: 'move' });
}

async function drag(from: Place, to: Place): Promise<void> {
  await page().mouse.move(from.x, from.y);
  await page().mouse.down();
  await page().mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2);
  await page().mouse.move(to.x, to.y);
}

/** Where the first camera shows the right hand of the human in this view, and its outer ring. */
const hand = { x: 350, y: 238 };
const outerRadius = 90;

test('the outer ring turns a joint in the view, and q gives it the axes of the scene', async () => {
  await row('Right hand').click();
  const start = await getPose(page());
  const from = await findRing(
    { x: hand.x - 4, y: hand.y + outerRadius - 8 },
    { x: hand.x + 4, y: hand.y + outerRadius + 8 },
    2,
  );
  const text = page().locator('.active-dof');
  const angle = async (): Promise<number> => Number(/(-?[\d.]+)°/.exec(await text.innerText())![1]);
  await drag(from, { x: hand.x + outerRadius, y: hand.y });
  await expect(text).toContainText('Right hand in the view');
  // From below to the right is a quarter turn counterclockwise.
  expect(Math.abs((await angle()) - 90)).toBeLessThan(4);
  expect(Object.keys(changes(start, await getPose(page())))).toEqual(['Right hand']);
  await page().mouse.up();
  await page().keyboard.press('Control+z');
  expect(await getPose(page())).toEqual(start);

  await page().keyboard.press('q');
  const ring = await findRing(
    { x: hand.x - 54, y: hand.y - 54 },
    { x: hand.x + 54, y: hand.y + 54 },
    7,
  );
  await page().keyboard.down('Control');
  await drag(ring, { x: ring.x + 60, y: ring.y + 70 });
  await page().keyboard.up('Control');
  await expect(text).toContainText(
    /about the scene’s [XYZ] -?(15|30|45|60|75|90|105|120|135|150|165|180)°/,
  );
  expect(Object.keys(changes(start, await getPose(page())))).toEqual(['Right hand']);
  await page().keyboard.press('Escape');
  await page().mouse.up();
  expect(await getPose(page()), 'canceled').toEqual(start);
  await page().keyboard.press('q');
});

test('several joints turn together by sliders, rings and keys, until Escape keeps one', async () => {
  await row('Left hand').click();
  await row('Left forearm').click({ modifiers: ['Control'] });
  await row('Right hand').click({ modifiers: ['Shift'] });
  await expect(selected()).toHaveCount(3);
  await expect(page().locator('.selected-joint > .lil-title')).toHaveText('Right hand and 2 more');
  const start = await getPose(page());
  const ring = await findRing(
    { x: hand.x - 54, y: hand.y - 54 },
    { x: hand.x + 54, y: hand.y + 54 },
    7,
  );
  await drag(ring, { x: ring.x + 20, y: ring.y + 24 });
  await page().mouse.up();
  const turned = Object.entries(changes(start, await getPose(page())));
  expect(turned.map(([name]) => name).sort()).toEqual(['Left forearm', 'Left hand', 'Right hand']);
  const [first, ...others] = turned.map(([, change]) => change);
  expect(first!.filter((each) => each !== 0)).toHaveLength(1);
  for (const change of others) {
    change.forEach((each, axis) => expect(each).toBeCloseTo(first![axis]!, 9));
  }
  await page().keyboard.press('Control+z');
  expect(await getPose(page()), 'one step').toEqual(start);
  await page().keyboard.press('Alt+ArrowRight');
  expect(Object.keys(changes(start, await getPose(page())))).toHaveLength(3);
  await page().keyboard.press('Control+z');

  await page().keyboard.press('Escape');
  await expect(selected()).toHaveCount(1);
  const several = page().locator('.view-joint [data-command=select-several]');
  await several.click();
  await row('Head').click();
  await expect(selected()).toHaveCount(2);
  await row('Head').click();
  await expect(selected(), 'taken out').toHaveText([/Right hand$/]);
  await several.click();
});

test('keys alone find a joint, select it, turn its axes and say so', async () => {
  const start = await getPose(page());
  await page().getByRole('searchbox', { name: 'Search joints' }).focus();
  await page().keyboard.press('Tab');
  await page().keyboard.type('left ha');
  await expect(row('Left hand')).toBeFocused();
  await page().keyboard.press('Enter');
  await expect(selected()).toHaveText(/Left hand$/);
  await expect(row('Left hand')).toBeFocused();
  const value = async (axis: number): Promise<number> =>
    (await getPose(page())).joints!['Left hand']![axis]! - start.joints!['Left hand']![axis]!;
  const degree = Math.PI / 180;
  await page().keyboard.press('Alt+ArrowRight');
  await page().keyboard.press('Alt+Shift+ArrowLeft');
  expect(await value(0)).toBeCloseTo(4.5 * degree, 9);
  await expect(spoken()).toHaveText(/^Left hand X -?[\d.]+°$/);
  await page().keyboard.press('Alt+ArrowDown');
  await page().keyboard.press('Alt+ArrowLeft');
  expect(await value(1)).toBeCloseTo(-5 * degree, 9);
  await expect(spoken()).toHaveText(/^Left hand Y -?[\d.]+°$/);
  await page().keyboard.press('Shift+ArrowDown');
  await expect(selected()).toHaveCount(2);
  await page().keyboard.press('Shift+ArrowUp');
  await expect(selected()).toHaveText(/Left hand$/);

  // A press brings the focus too, but whoever presses a row goes on in the view.
  await row('Neck').click();
  await page().keyboard.press('m');
  await expect(row('Neck')).toBeFocused();
  const boneMode = page().locator('[data-command=bone-mode]').first();
  await expect(boneMode).toHaveAttribute('aria-pressed', 'true');
  await page().keyboard.press('m');
  await expect(boneMode).toHaveAttribute('aria-pressed', 'false');
});

test('the list of steps goes to any of them, by pointer and by keys', async () => {
  await row('Right hand').click();
  const poses: Pose[] = [await getPose(page())];
  for (let i = 0; i < 3; i++) {
    await row('Right hand').press('Alt+ArrowRight');
    poses.push(await getPose(page()));
  }
  await page().locator('canvas.scene').focus();
  await page().keyboard.press('y');
  await expect(history()).toBeFocused();
  const last = await steps().count();
  await page().keyboard.press('ArrowUp');
  await page().keyboard.press('ArrowUp');
  await page().keyboard.press('Enter');
  expect(await getPose(page())).toEqual(poses[1]);
  await expect(page().locator('.history .undone')).toHaveCount(2);
  await steps()
    .nth(last - 4)
    .click();
  expect(await getPose(page())).toEqual(poses[0]);
  await steps()
    .nth(last - 1)
    .click();
  expect(await getPose(page())).toEqual(poses[3]);
  await expect(history()).toHaveText('Turn Right hand X');
  await expect(page().locator('.notice')).toHaveText('Went to: Turn Right hand X');
  expect(await violations(page(), { within: '.history' })).toEqual([]);
});

test('limits stand at the rings as sectors with the present value', async ({ page }) => {
  await openView(page, 'model=insect');
  const joint = page.locator('[role=treeitem]').filter({ hasText: /antenna_l_scape$/ });
  await joint.dispatchEvent('click');
  await page.keyboard.press('Alt+ArrowRight');
  await page.mouse.move(300, 240);
  for (let i = 0; i < 3; i++) await page.mouse.wheel(0, -150);
  await page.mouse.move(5, 5);
  // Its fonts differ from machine to machine.
  await page.locator('.overlay').evaluate((element: HTMLElement) => {
    element.style.visibility = 'hidden';
  });
  await page.evaluate(() => window.sinew.settled());
  expectPicture('gizmo-limits', await page.locator('canvas.scene').screenshot());
});
