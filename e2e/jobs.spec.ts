import { readFileSync } from 'node:fs';
import { type Browser, type Download, expect, type Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { bytesOf, capture, getPose } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { catalogue } from './support/catalogue.ts';
import { countedUser } from './support/counted-user.ts';
import { courseCharacter } from './support/course-character.ts';
import { find, type Place } from './support/find-limb.ts';
import { keyboardUser } from './support/keyboard-user.ts';
import { expectPicture } from './support/pictures.ts';
import { doStudentsJob, expectElbowTurned } from './support/student.ts';
import { coarse, openBundled, test } from './support/test.ts';
import { touchUser } from './support/touch-user.ts';

// What people come for, with the presses and drags that it may cost. By touch and by keyboard alone
// the same can be done, at any cost; `npm run test:long -- jobs` does it so as well.
test.use({ ...coarse, viewport: { width: 960, height: 540 } });
const ways = process.env['JOBS_WAYS'] ?? 'pointer';

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

/** A part of the view; the numbers are parts of its width and height. */
async function partOfView(page: Page, right: number, down: number): Promise<Place> {
  const { x, y, width, height } = (await page.locator('canvas.scene').boundingBox())!;
  return { x: x + right * width, y: y + down * height };
}

/** Finds the right forearm near a part of the view. */
async function findArm(page: Page, right: number, down: number): Promise<Place> {
  const { x, y } = await partOfView(page, right, down);
  return find(page, { x: x - 12, y: y - 20 }, { x: x + 12, y: y + 20 }, 4, { limb: arm });
}

/** Where the first visit shows the arm that gives its hand to the dog. */
const firstArm = [0.375, 0.5] as const;

/** The rotations of the right forearm, of every character. */
const turned = (page: Page) =>
  page.evaluate(
    (arm) =>
      window.sinew.characters.map(({ id }) => window.sinew.pose(undefined, id).joints?.[arm]),
    arm,
  );

async function expectPortrait(download: Promise<Download>): Promise<void> {
  const { width, height } = PNG.sync.read(readFileSync(await (await download).path()));
  expect(width / height).toBeCloseTo(4 / 5, 2);
}

/** What a rigger came for: the joints of a vertex, and the error of keeping few of them. */
const owners = (page: Page) => page.getByRole('region', { name: 'Marked vertex' });
const owner = (page: Page) => owners(page).locator('tbody tr').first();
const keep = (page: Page) =>
  page.locator('.lil-controller:has(.lil-name:text-is("Keep influences")) select');
const weights = (page: Page) => page.locator('[data-section="weights"]');
const error = /At most 0\.\d+ \(\S+ % of the height\)/;

/** Where the two people of an artist have their right forearms, in a window and on a phone. */
const artistsArms = [
  [0.157, 0.43],
  [0.528, 0.45],
] as const;
async function expectAccessible(page: Page): Promise<void> {
  const within = '.weights-card, [data-section=weights]';
  expect(await violations(page, { within })).toEqual([]);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page, { within, ...onlyColors })).toEqual([]);
}

function asUploads() {
  return courseCharacter().map(({ name, content }) => ({
    name,
    mimeType: 'application/octet-stream',
    buffer: Buffer.from(content),
  }));
}

test('a student drops a character, turns its elbow and saves the picture: 8 presses', async ({
  page,
}) => {
  await visit(page);
  expect(await doStudentsJob(page, courseCharacter())).toBeLessThanOrEqual(8);
});

test('a newcomer, a sharer and a collector reach their aims: 4, 2 and 6 presses', async ({
  page,
  browser,
}) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await visit(page);

  await test.step('the newcomer turns the camera, raises an arm by hand and undoes it', async () => {
    const user = countedUser(page);
    const [pose, first] = [await getPose(page), await capture(page)];
    // The drag begins on a character, and is the camera's all the same.
    await user.drag(await partOfView(page, 0.46, 0.53), 30, 6);
    expect(await getPose(page), 'the first drag never bends a character').toEqual(pose);
    const turned = await capture(page);
    expect(turned.equals(first), 'but turns the camera').toBe(false);

    const place = await findArm(page, ...firstArm);
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

  await test.step('the sharer sends a link, and another sees the same picture', async () => {
    const user = countedUser(page);
    await user.click(page.getByRole('button', { name: 'File', exact: true }));
    await user.click(page.getByRole('menuitem', { name: 'Copy link' }));
    await expectShared(page, browser);
    expect(user.presses).toBeLessThanOrEqual(2);
  });

  await test.step('the collector opens three characters beside one another', async () => {
    const user = countedUser(page);
    for (const { label } of collected) {
      await user.click(page.getByRole('button', { name: 'Add…' }));
      await user.click(page.getByRole('dialog').getByRole('button', { name: label, exact: true }));
    }
    await expectCollected(page, 2);
    expect(user.presses).toBeLessThanOrEqual(6);
  });
});

test('an artist lets two people shake hands and saves the picture: 25 presses', async ({
  page,
}) => {
  await openBundled(page, 'whole');
  await visit(page);
  const user = countedUser(page);
  const joint = (name: string) => page.getByRole('treeitem', { name, exact: true });
  const pinned = page.locator(
    '[data-section="joint"] .lil-controller:has(.lil-name:text-is("Pinned (l)")) input',
  );
  const field = (name: string) => page.getByRole('textbox', { name, exact: true });
  await user.click(page.getByRole('button', { name: 'Add…' }));
  await user.click(page.getByRole('dialog').getByRole('button', { name: 'Human', exact: true }));
  await expect.poll(() => names(page)).toEqual(['human']);
  await user.click(page.getByRole('button', { name: 'Reset all' }));
  for (const foot of ['Left foot', 'Right foot']) {
    await user.click(joint(foot));
    await user.click(pinned);
  }
  await user.click(joint('Right upper arm'));
  await user.type(field('Right upper arm X'), '-30°');
  await user.click(page.locator('.lil-title').filter({ hasText: /^Place$/ }));
  await user.type(field('Place Turn Y'), '90°');
  // The copy has its feet pinned too.
  await user.click(page.getByRole('button', { name: 'Duplicate the character' }));
  for (const [name, value] of [
    ['Place Turn Y', '-90°'],
    ['Place Move X', '0.5'],
    ['Place Move Z', '0.2'],
  ] as const) {
    await user.type(field(name), value);
  }
  await user.click(page.getByRole('button', { name: 'Frame the character' }));
  const before = await page.evaluate(() => window.sinew.pose());
  await user.click(joint('Right palm'));
  await user.click(pinned);
  const follows = page.locator('[data-section="pins"] select').last();
  await user.choose(follows, 'human: Right palm');
  await expect(page.locator('.status')).toContainText("Right palm follows human's Right palm");
  await page.evaluate(() => window.sinew.settled());
  expect((await page.evaluate(() => window.sinew.pose())).joints).not.toEqual(before.joints);
  await expect(page.locator('[data-section="pins"]'), 'all feet stay').not.toContainText('away');
  const shaken = { width: 320, height: 320, samples: 2 } as const;
  expectPicture(
    'handshake',
    await bytesOf(await page.evaluateHandle((size) => window.sinew.capture(size), shaken)),
  );
  const download = page.waitForEvent('download');
  await user.click(page.getByRole('button', { name: 'Save a picture' }));
  await download;
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
  await user.click(await partOfView(page, 0.5, 0.5));
  await expect(owner(page)).toHaveText(/^Chest\d\.\d{4}$/);
  await user.click(page.getByRole('tab', { name: 'Deform' }));
  await user.choose(keep(page), '4');
  await expect(weights(page)).toContainText(error);
  await expect(page.getByRole('region', { name: 'Legend of the weights' })).toContainText(
    'unmoved',
  );
  expect(user.presses).toBeLessThanOrEqual(8);
});

if (ways.includes('touch'))
  test.describe('by touch', () => {
    test.use({ ...coarse, viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

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
        const { tap, stroke } = await touchUser(page);
        const pose = await getPose(page);
        await stroke(await partOfView(page, 0.46, 0.53), 12, 3);
        expect(await getPose(page)).toEqual(pose);
        const place = await findArm(page, ...firstArm);
        await tap(place);
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

    const panelsOf = (page: Page) => page.getByRole('navigation', { name: 'Panels' });
    /** Opens a character instead of the first scene, and leaves the sheet open. */
    async function begin(page: Page, name: string): Promise<void> {
      await visit(page);
      await panelsOf(page).getByText('Characters').tap();
      await page.getByRole('button', { name: 'Add…' }).tap();
      await page.getByRole('dialog').getByRole('button', { name, exact: true }).tap();
      await expect.poll(() => names(page)).toEqual([name.toLowerCase()]);
    }

    test('an artist reaches their aim on a phone', async ({ page }) => {
      await begin(page, 'Human');
      const { tap, stroke } = await touchUser(page);
      const panels = panelsOf(page);
      await tap(page.getByRole('button', { name: 'Duplicate the character' }));
      await tap(panels.getByText('Characters'));
      await tap(page.getByRole('button', { name: 'Frame the character' }));
      await page.evaluate(() => window.sinew.settled());
      const [before] = await turned(page);
      for (const [right, down] of artistsArms) {
        const place = await findArm(page, right, down);
        await tap(place);
        await expect(selected(page)).toHaveText(new RegExp(arm));
        await stroke(place, 2, -24);
      }
      for (const now of await turned(page)) expect(now).not.toEqual(before);
      await tap(panels.getByText('Pose'));
      await tap(page.locator('.lil-title').filter({ hasText: 'Light and floor' }));
      const preset = page.locator('select[aria-label="Preset of light and floor"]');
      await tap(preset);
      await preset.selectOption('Low sun');
      await tap(panels.getByText('Pose'));
      await tap(page.getByRole('button', { name: 'Keep this view as a shot' }).first());
      await page.locator('.shot-bar select').selectOption('4:5');
      const download = page.waitForEvent('download');
      await tap(page.getByRole('button', { name: 'Save a picture' }));
      await expectPortrait(download);
    });

    test('a rigger reaches their aim on a phone', async ({ page }) => {
      await begin(page, 'Dog');
      const { tap } = await touchUser(page);
      const panels = panelsOf(page);
      await tap(panels.getByText('Characters'));
      await tap(page.getByRole('button', { name: 'Show the weights in color' }));
      await tap(await partOfView(page, 0.5, 0.5));
      await expect(owner(page)).toHaveText(/^Chest\d\.\d{4}$/);
      await tap(panels.getByText('Deform'));
      await keep(page).selectOption('4');
      await expect(weights(page)).toContainText(error);
      await expect(owner(page), 'is still in sight').toBeInViewport();
    });
  });

if (ways.includes('keys'))
  test.describe('by keyboard', () => {
    test('by keyboard alone, a student, a newcomer, a collector and a sharer reach their aims', async ({
      page,
    }) => {
      await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
      await visit(page);
      const { keyboard } = page;
      const { command, tabTo } = keyboardUser(page);

      await test.step('the sharer', async () => {
        await command('Copy a link of the scene');
        await expect(page.locator('.status')).toContainText('Link copied');
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
          await expect(
            page.getByRole('dialog').getByRole('button', { name: label }),
          ).not.toHaveCount(0);
          await tabTo(label);
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

    test('by keyboard alone, an artist and a rigger reach their aims', async ({ page }) => {
      await visit(page);
      const { keyboard } = page;
      const { command } = keyboardUser(page);

      await test.step('the artist', async () => {
        await command('Open Human');
        await expect.poll(() => names(page)).toEqual(['human']);
        await keyboard.press('ControlOrMeta+d');
        await expect.poll(() => names(page)).toHaveLength(2);
        await keyboard.press('Home');
        const [before] = await turned(page);
        for (const name of ['human', 'human 2']) {
          await command(`Select the character ${name}`);
          await command(`Select ${arm}`);
          await expect(page.getByRole('slider', { name: `${arm} X` })).toBeFocused();
          await keyboard.press('PageUp');
        }
        for (const now of await turned(page)) expect(now).not.toEqual(before);
        await command('Light: Low sun');
        await command('Keep this view as a shot');
        for (const aspect of ['1:1', '4:5']) {
          await command(`Aspect of the shot: ${aspect}`);
          await expect(page.locator('.shot-bar select')).toHaveValue(aspect);
        }
        const download = page.waitForEvent('download');
        await command('Save a picture');
        await expectPortrait(download);
      });

      await test.step('the rigger', async () => {
        await command('Open Dog');
        await expect.poll(() => names(page)).toContain('dog');
        await command('Show the weights in color');
        await command('Mark a vertex by its number');
        await expect(page.getByRole('spinbutton', { name: 'Vertex number' })).toBeFocused();
        await keyboard.type('4453');
        await expect(owner(page)).toHaveText(/^Neck 60\.\d{4}$/);
        await command('Keep influences: 4');
        await expect(weights(page)).toContainText(error);
        await expectAccessible(page);
      });
    });
  });
