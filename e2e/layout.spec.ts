import { expect, type Page } from '@playwright/test';
import { drop, openApp, openTab } from './support/app.ts';
import { expectGoodBoxes } from './support/boxes.ts';
import { courseCharacter } from './support/course-character.ts';
import { coarse, test } from './support/test.ts';

// Everything is in the window, nothing lies over a control, and targets are large enough, at the
// sizes of a large and a small screen, a tablet and a phone.
const tasks = ['pose', 'deform', 'animate'] as const;
const mouseTarget = 24;
const touchTarget = 44;

test.describe('by mouse', () => {
  test.use({ ...coarse, viewport: { width: 1440, height: 900 } });

  test('controls have their own places, and all angles of a course’s character are in view', async ({
    page,
  }) => {
    await openApp(page, 'model=insect');
    for (const size of [
      { width: 1440, height: 900 },
      { width: 1024, height: 768 },
      { width: 820, height: 1180 },
    ]) {
      await page.setViewportSize(size);
      for (const task of tasks) {
        await openTab(page, task);
        await expectGoodBoxes(page, `${size.width}, ${task}`, mouseTarget);
      }
    }
    await page.setViewportSize({ width: 1440, height: 900 });
    await openTab(page, 'pose');
    await drop(page, courseCharacter());
    await page.getByRole('button', { name: '6.837 look' }).click();
    const angles = page.locator('.joints').getByRole('slider', { name: /^(?!.*move).* [XYZ]$/i });
    await expect(angles).toHaveCount(18 * 3);
    // The status line begins where the inspector ends.
    const bottom = (await page.locator('.status').boundingBox())!.y;
    const ends = await angles.evaluateAll((all) =>
      all.map((each) => each.getBoundingClientRect().bottom),
    );
    expect(Math.max(...ends)).toBeLessThanOrEqual(bottom);
    await expectGoodBoxes(page, 'the look of the course', mouseTarget);
  });
});

test.describe('by touch', () => {
  test.use({ ...coarse, viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('controls have their own places, with the sheets open and closed', async ({ page }) => {
    await page.goto('./?model=insect');
    await page.evaluate(() => window.sinew.ready);
    for (const size of [
      { width: 390, height: 844 },
      { width: 360, height: 640 },
    ]) {
      await page.setViewportSize(size);
      await expectGoodBoxes(page, `${size.width}`, touchTarget);
      // What fits the smaller one fits both.
      if (size.width > 360) continue;
      const panels = page.getByRole('navigation', { name: 'Panels' });
      for (const name of ['Characters', 'Pose', 'Deform', 'Animate']) {
        const button = panels.getByText(name);
        await button.tap();
        // Its first press is for the timeline.
        if (name === 'Animate') {
          await page.locator('.sheet-view canvas').waitFor();
          await expectGoodBoxes(page, `${size.width} timeline`, touchTarget);
          await button.tap();
        }
        await expect(page.locator('[data-section]:not([hidden]):empty')).toHaveCount(0);
        for (const end of [0, 1e6]) {
          await scrollPanels(page, end);
          await expectGoodBoxes(page, `${size.width} ${name} ${end}`, touchTarget);
        }
        await button.tap();
      }
    }
    await page.setViewportSize({ width: 820, height: 1180 });
    for (const task of tasks) {
      await openTab(page, task);
      await expectGoodBoxes(page, `820, ${task}`, touchTarget);
    }
    await page.getByRole('button', { name: 'Characters and joints' }).tap();
    await expectGoodBoxes(page, '820, unfolded', touchTarget);

    await test.step('the help sheet opens scrolled to its top', async () => {
      await page.setViewportSize({ width: 360, height: 640 });
      await page.getByRole('button', { name: 'Show all keys' }).tap();
      const sheet = page.getByRole('dialog');
      await expect(sheet.getByRole('button', { name: 'Close' })).toBeFocused();
      expect(await sheet.evaluate(({ scrollTop }) => scrollTop)).toBe(0);
      await sheet.getByRole('button', { name: 'Close' }).tap();
    });

    await test.step('the view keeps its size whatever the selection and the messages are', async () => {
      await page.evaluate(() => window.sinew.add('tube'));
      for (const width of [390, 820, 1024]) {
        await page.setViewportSize({ width, height: 844 });
        const heights: number[] = [];
        for (const name of ['insect', 'tube', 'insect']) {
          await page.evaluate((name) => window.sinew.select(name), name);
          await page.evaluate(() => window.sinew.settled());
          heights.push(
            await page.locator('canvas.scene').evaluate((canvas) => canvas.clientHeight),
          );
          await page.evaluate(() =>
            window.sinew.open([new File(['0'], `${'long name '.repeat(9)}.txt`)]),
          );
        }
        expect(new Set(heights).size, heights.join()).toBe(1);
        expect(await page.evaluate(() => window.sinew.characters.length)).toBe(2);
      }
    });
  });
});

async function scrollPanels(page: Page, to: number): Promise<void> {
  await page.locator('aside').evaluateAll((panels, to) => {
    for (const panel of panels) panel.scrollTo(0, to);
  }, to);
}
