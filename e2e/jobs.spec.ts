import { readFileSync } from 'node:fs';
import { type Browser, expect, type Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { capture, getPose } from './support/app.ts';
import { catalogue } from './support/catalogue.ts';
import { countedUser } from './support/counted-user.ts';
import { courseCharacter } from './support/course-character.ts';
import { find, type Place } from './support/find-limb.ts';
import { doStudentsJob, expectElbowTurned } from './support/student.ts';
import { test } from './support/test.ts';

// What people come for, with the presses and drags that it may cost. By touch and by keyboard alone
// the same can be done, at any cost.
test.use({ viewport: { width: 1000, height: 640 } });
test.describe.configure({ timeout: 90_000 }); // a limb is found by many pictures

const arm = 'Right forearm';
const selected = (page: Page) => page.locator('[role=treeitem][aria-selected=true]');
const names = (page: Page) => page.evaluate(() => window.sinew.characters.map(({ name }) => name));

/** The first character of each course, and more of them if a course has none. */
const collected = [
  ...new Set([
    ...['mit', 'cse169', 'mmd'].map((each) => catalogue.find(({ course }) => course === each)),
    ...catalogue,
  ]),
]
  .filter((entry) => entry !== undefined)
  .slice(0, 3);

async function visit(page: Page): Promise<void> {
  await page.goto('./');
  await page.evaluate(() => window.sinew.ready);
  await page.evaluate(() => window.sinew.settled());
  await expect(page.locator('[data-section]:not([hidden]):empty')).toHaveCount(0);
}

/** @param kept the count of characters that somebody touched, which stay */
async function expectCollected(page: Page, kept = 0): Promise<void> {
  await expect.poll(() => names(page)).toHaveLength(kept + 3);
  await page.evaluate(() => window.sinew.settled());
  expect(new Set((await names(page)).slice(kept)).size).toBe(3);
  expect(await page.evaluate(() => window.sinew.problems)).toEqual([]);
}

/** Opens the link that was copied in another browser, and compares the pictures by the byte. */
async function expectShared(page: Page, browser: Browser): Promise<void> {
  await expect(page.locator('.status')).toContainText('Link copied');
  const link = await page.evaluate(() => navigator.clipboard.readText());
  const shared = await capture(page);
  const other = await (await browser.newContext({ viewport: page.viewportSize() })).newPage();
  await other.goto(link);
  await other.evaluate(() => window.sinew.ready);
  await other.evaluate(() => window.sinew.settled());
  expect((await capture(other)).equals(shared), 'the same picture').toBe(true);
  await other.context().close();
}

/** The part of the view where the first visit shows the arm that gives its hand to the dog. */
async function middle(page: Page): Promise<[Place, Place]> {
  const { x, y, width, height } = (await page.locator('canvas').boundingBox())!;
  return [
    { x: x + 0.36 * width, y: y + 0.46 * height },
    { x: x + 0.56 * width, y: y + 0.6 * height },
  ];
}

test('a student drops a character, turns its elbow and saves the picture: 8 presses', async ({
  page,
}) => {
  await visit(page);
  expect(await doStudentsJob(page, courseCharacter())).toBeLessThanOrEqual(8);
});

test('a newcomer turns the camera, raises an arm by hand and undoes it: 4 presses', async ({
  page,
}) => {
  await visit(page);
  const user = countedUser(page);
  const [pose, first] = [await getPose(page), await capture(page)];
  const [from, to] = await middle(page);
  // The drag begins on a character, and is the camera's all the same.
  await user.drag({ x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 }, 30, 6);
  expect(await getPose(page), 'the first drag never bends a character').toEqual(pose);
  const turned = await capture(page);
  expect(turned.equals(first), 'but turns the camera').toBe(false);

  const place = await find(page, from, to, 8, { limb: arm });
  await user.click(place);
  await expect(selected(page)).toHaveText(new RegExp(arm));
  await user.drag(place, 4, -40);
  const raised = await getPose(page);
  expect(raised.joints![arm]).not.toEqual(pose.joints![arm]);
  expect({ ...raised.joints, [arm]: null }).toEqual({ ...pose.joints, [arm]: null });

  await user.click(page.getByRole('button', { name: 'Undo' }));
  expect(await getPose(page), 'to the bit').toEqual(pose);
  expect((await capture(page)).equals(turned), 'the camera rested').toBe(true);
  expect(user.presses).toBeLessThanOrEqual(4);
});

test('a collector opens three characters beside one another from the gallery: 6 presses', async ({
  page,
}) => {
  await visit(page);
  const user = countedUser(page);
  for (const { label } of collected) {
    await user.click(page.getByRole('button', { name: 'Add…' }));
    await user.click(page.getByRole('dialog').getByRole('button', { name: label, exact: true }));
  }
  await expectCollected(page);
  expect(user.presses).toBeLessThanOrEqual(6);
});

test('a sharer sends a link, and another sees the same picture: 2 presses', async ({
  page,
  browser,
}) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await visit(page);
  await page.keyboard.press('ArrowLeft');
  const user = countedUser(page);
  await user.click(page.getByRole('button', { name: 'File', exact: true }));
  await user.click(page.getByRole('menuitem', { name: 'Copy link' }));
  await expectShared(page, browser);
  expect(user.presses).toBeLessThanOrEqual(2);
});

test('an artist poses two people side by side, lights them and saves a framed picture: 25 presses', async ({
  page,
}) => {
  await visit(page);
  const user = countedUser(page);
  await user.click(page.getByRole('button', { name: 'Add…' }));
  await user.click(page.getByRole('dialog').getByRole('button', { name: 'Human', exact: true }));
  await expect.poll(() => names(page)).toEqual(['human']);
  await user.click(page.getByRole('button', { name: 'Duplicate the character' }));
  await user.click(page.getByRole('button', { name: 'Frame the character' }));
  await page.evaluate(() => window.sinew.settled());
  const { x, y, width, height } = (await page.locator('canvas').boundingBox())!;
  const poses = () =>
    page.evaluate(() => window.sinew.characters.map(({ id }) => window.sinew.pose(undefined, id)));
  const [before] = await poses();
  for (const [right, down] of [
    [0.157, 0.43],
    [0.528, 0.45],
  ] as const) {
    const at = { x: x + right * width, y: y + down * height };
    const [from, to] = [
      { x: at.x - 12, y: at.y - 24 },
      { x: at.x + 12, y: at.y + 24 },
    ];
    const place = await find(page, from, to, 4, { limb: arm });
    await user.click(place);
    await expect(selected(page)).toHaveText(new RegExp(arm));
    await user.drag(place, 4, -30);
  }
  const [one, other] = await poses();
  for (const pose of [one, other]) expect(pose!.joints![arm]).not.toEqual(before!.joints![arm]);

  const plain = await capture(page);
  await user.click(page.locator('.lil-title').filter({ hasText: 'Light and floor' }));
  await user.choose(page.locator('select[aria-label="Preset of light and floor"]'), 'Low sun');
  expect((await capture(page)).equals(plain), 'they are lit').toBe(false);
  await user.click(page.getByRole('button', { name: 'Keep this view as a shot' }).first());
  await user.choose(page.locator('.shot-bar select'), '4:5');
  const download = page.waitForEvent('download');
  await user.click(page.getByRole('button', { name: 'Save a picture' }));
  const picture = PNG.sync.read(readFileSync(await (await download).path()));
  expect(picture.width / picture.height).toBeCloseTo(4 / 5, 2);
  expect(user.presses).toBeLessThanOrEqual(25);
});

test('a rigger finds the joint that owns a vertex, keeps four influences and reads the error: 8 presses', async ({
  page,
}) => {
  await visit(page);
  const user = countedUser(page);
  await user.click(page.getByRole('button', { name: 'Add…' }));
  await user.click(page.getByRole('dialog').getByRole('button', { name: 'Dog', exact: true }));
  await expect.poll(() => names(page)).toEqual(['dog']);
  await user.click(page.getByRole('button', { name: 'Show the weights in color' }));
  await user.click(page.getByRole('tab', { name: 'Deform' }));
  await user.type(page.getByRole('spinbutton', { name: 'Vertex number' }), '4453');
  await expect(page.getByRole('region', { name: 'Marked vertex' })).toContainText(
    /#4453.*0\.\d{4}.*influences/,
  );
  // Choosing from a menu is two presses.
  const keep = page.locator('.lil-controller:has(.lil-name:text-is("Keep influences")) select');
  await user.click(keep);
  await keep.selectOption({ label: '4' });
  await expect(page.locator('[data-section="weights"]')).toContainText(
    /at most .* % of the height/,
  );
  await expect(page.getByRole('region', { name: 'Legend of the weights' })).toContainText(
    'unmoved',
  );
  expect(user.presses + 1).toBeLessThanOrEqual(8);
});

test.describe('by touch', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('a student, a newcomer, a collector and a sharer reach their aims on a phone', async ({
    page,
  }) => {
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await visit(page);
    const panels = page.getByRole('navigation', { name: 'Panels' });

    await test.step('the sharer', async () => {
      await page.getByRole('button', { name: 'File', exact: true }).tap();
      await page.getByRole('menuitem', { name: 'Copy link' }).tap();
      await expect(page.locator('.status')).toContainText('Link copied');
    });

    await test.step('the newcomer', async () => {
      const client = await page.context().newCDPSession(page);
      const stroke = async ({ x, y }: Place, right: number, down: number): Promise<void> => {
        const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', part?: number) =>
          client.send('Input.dispatchTouchEvent', {
            type,
            touchPoints:
              part === undefined ? [] : [{ x: x + part * right, y: y + part * down, id: 0 }],
          });
        await touch('touchStart', 0);
        for (const part of [0.5, 1]) await touch('touchMove', part);
        await touch('touchEnd');
      };
      const pose = await getPose(page);
      const [from, to] = await middle(page);
      await stroke({ x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 }, 12, 3);
      expect(await getPose(page)).toEqual(pose);
      const place = await find(page, from, to, 6, { limb: arm });
      await page.touchscreen.tap(place.x, place.y);
      await expect(selected(page)).toHaveText(new RegExp(arm));
      await stroke(place, 2, -24);
      expect((await getPose(page)).joints![arm]).not.toEqual(pose.joints![arm]);
      await page.getByRole('button', { name: 'Undo' }).tap();
      expect(await getPose(page)).toEqual(pose);
    });

    await test.step('the collector', async () => {
      await panels.getByText('Characters').tap();
      for (const { label } of collected) {
        await page.getByRole('button', { name: 'Add…' }).tap();
        await page.getByRole('dialog').getByRole('button', { name: label, exact: true }).tap();
        await expect(page.getByRole('dialog')).toHaveCount(0);
      }
      await expectCollected(page, 2);
    });

    await test.step('the student', async () => {
      const chooser = page.waitForEvent('filechooser');
      await page.getByRole('button', { name: 'File', exact: true }).tap();
      await page.getByRole('menuitem', { name: 'Add files…' }).tap();
      await (await chooser).setFiles(asUploads());
      await page.getByRole('treeitem', { name: 'Right elbow' }).tap();
      await panels.getByText('Pose').tap();
      const field = page.locator('input[aria-label="Right elbow Z"]:visible');
      await field.tap();
      await field.fill('1.57');
      await field.press('Enter');
      await expectElbowTurned(page);
      const download = page.waitForEvent('download');
      await page.getByRole('button', { name: 'Save a picture' }).tap();
      expect((await download).suggestedFilename()).toBe('course.png');
    });
  });
});

test('by keyboard alone, a student, a newcomer, a collector and a sharer reach their aims', async ({
  page,
  browser,
}) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await visit(page);
  const { keyboard } = page;
  const command = async (words: string): Promise<void> => {
    await keyboard.press('ControlOrMeta+k');
    await expect(page.getByRole('combobox', { name: 'Search the commands' })).toBeFocused();
    await keyboard.type(words);
    await keyboard.press('Enter');
  };
  const focused = () => page.evaluate(() => document.activeElement?.getAttribute('aria-label'));
  const tabTo = async (label: string): Promise<void> => {
    for (let count = 0; (await focused()) !== label; count++) {
      expect(count, `steps to ${label}`).toBeLessThan(40);
      await keyboard.press('Tab');
    }
  };

  await test.step('the sharer', async () => {
    await command('Copy a link of the scene');
    await expectShared(page, browser);
  });

  await test.step('the newcomer', async () => {
    const [pose, first] = [await getPose(page), await capture(page)];
    await keyboard.press('ArrowLeft');
    expect((await capture(page)).equals(first), 'the camera turned').toBe(false);
    await command(`Select ${arm}`);
    await expect(page.getByRole('slider', { name: `${arm} X` })).toBeFocused();
    await keyboard.press('PageUp');
    expect((await getPose(page)).joints![arm]).not.toEqual(pose.joints![arm]);
    await keyboard.press('ControlOrMeta+z');
    expect(await getPose(page)).toEqual(pose);
  });

  await test.step('the collector', async () => {
    for (const { label } of collected) {
      await command('Add a character');
      const card = page.getByRole('dialog').getByRole('button', { name: label, exact: true });
      await expect(card).toBeVisible();
      for (let count = 0; !(await card.evaluate((it) => it === document.activeElement)); count++) {
        expect(count, `steps to ${label}`).toBeLessThan(40);
        await keyboard.press('Tab');
      }
      await keyboard.press('Enter');
      await expect(page.getByRole('dialog')).toHaveCount(0);
    }
    await expectCollected(page, 2);
  });

  await test.step('the student', async () => {
    const chooser = page.waitForEvent('filechooser');
    await command('Add files to the scene');
    await (await chooser).setFiles(asUploads());
    await expect.poll(async () => (await names(page)).includes('course')).toBe(true);
    await command('Select Right elbow');
    await expect(page.getByRole('slider', { name: 'Right elbow X' })).toBeFocused();
    await tabTo('Right elbow Z');
    if ((await page.evaluate(() => document.activeElement?.tagName)) !== 'INPUT') {
      await keyboard.press('Tab');
      await tabTo('Right elbow Z');
    }
    await keyboard.press('ControlOrMeta+a');
    await keyboard.type('1.57');
    await keyboard.press('Enter');
    await expectElbowTurned(page);
    const download = page.waitForEvent('download');
    await command('Save a picture');
    expect((await download).suggestedFilename()).toBe('course.png');
  });
});

function asUploads() {
  return courseCharacter().map(({ name, content }) => ({
    name,
    mimeType: 'application/octet-stream',
    buffer: Buffer.from(content),
  }));
}
