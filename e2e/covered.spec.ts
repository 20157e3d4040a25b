import { expect, type Page } from '@playwright/test';
import { openTab } from './support/app.ts';
import { test } from './support/test.ts';

// Nothing covers a control, and neither messages nor the selection move the view.
test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

const sizes = [
  { width: 390, height: 844 },
  { width: 360, height: 640 },
  { width: 820, height: 1180 },
  { width: 1024, height: 768 },
];

test('at every size each visible control can be pressed, with the sheets open and closed', async ({
  page,
}) => {
  test.setTimeout(90_000);
  await page.goto('./?model=insect');
  await page.evaluate(() => window.sinew.ready);
  await openTab(page, 'animate');
  await expect(page.getByRole('region', { name: 'Timeline' })).toBeVisible();
  for (const size of sizes) {
    await page.setViewportSize(size);
    await expectNothingCovered(page, `${size.width}`);
    if (size.width >= 720) continue;
    const panels = page.getByRole('navigation', { name: 'Panels' });
    for (const name of ['Characters', 'Pose', 'Deform', 'Animate']) {
      const button = panels.getByText(name);
      await button.tap();
      for (const end of [0, 1e6]) {
        await page.locator('aside').evaluateAll((sheets, end) => {
          for (const sheet of sheets) sheet.scrollTo(0, end);
        }, end);
        await expectNothingCovered(page, `${size.width} ${name} ${end}`);
      }
      await button.tap();
    }
  }

  await test.step('the help sheet opens scrolled to its top', async () => {
    await page.setViewportSize(sizes[1]!);
    await page.getByRole('button', { name: 'Show all keys' }).tap();
    const sheet = page.getByRole('dialog');
    await expect(sheet.getByRole('button', { name: 'Close' })).toBeFocused();
    expect(await sheet.evaluate(({ scrollTop }) => scrollTop)).toBe(0);
    await sheet.getByRole('button', { name: 'Close' }).tap();
  });

  await test.step('the view keeps its size whatever the selection and the messages are', async () => {
    await page.evaluate(() => window.sinew.add('tube'));
    for (const size of sizes) {
      await page.setViewportSize(size);
      const heights: number[] = [];
      for (const name of ['insect', 'tube', 'insect']) {
        await page.evaluate((name) => window.sinew.select(name), name);
        await page.evaluate(() => window.sinew.settled());
        heights.push(await page.locator('canvas').evaluate((canvas) => canvas.clientHeight));
        await page.evaluate(() =>
          window.sinew.open([new File(['0'], `${'long name '.repeat(9)}.txt`)]),
        );
      }
      expect(new Set(heights).size, heights.join()).toBe(1);
      expect(await page.evaluate(() => window.sinew.characters.length)).toBe(2);
    }
  });
});

async function expectNothingCovered(page: Page, where: string): Promise<void> {
  // This waits two frames, until the layout has followed what was pressed.
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );
  const { covered, count } = await page.evaluate(() => {
    const covered: string[] = [];
    let count = 0;
    const controls =
      'button, select, input, summary, [role=slider], [role=treeitem], [tabindex="0"]:not(canvas)';
    for (const control of document.querySelectorAll(controls)) {
      if (!control.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
      const { left, right, top, bottom } = control.getBoundingClientRect();
      const [x, y] = [(left + right) / 2, (top + bottom) / 2];
      // A control that its panel has scrolled away is not visible.
      const seen = { left: 0, top: 0, right: innerWidth, bottom: innerHeight };
      let scrolls = false;
      for (let around = control.parentElement; around; around = around.parentElement) {
        if (getComputedStyle(around).overflowY === 'visible') continue;
        const box = around.getBoundingClientRect();
        seen.left = Math.max(seen.left, box.left);
        seen.top = Math.max(seen.top, box.top);
        seen.right = Math.min(seen.right, box.right);
        seen.bottom = Math.min(seen.bottom, box.bottom);
        scrolls ||= around.scrollHeight > around.clientHeight;
      }
      const name = `${control.getAttribute('aria-label') ?? ''} ${control.textContent}`;
      const inSight = x > seen.left && x < seen.right && y > seen.top && y < seen.bottom;
      // The rest of the page does not scroll, so it must fit in the window.
      if (!inSight && !scrolls) covered.push(`out of the window: ${name}`);
      if (!inSight) continue;
      count++;
      const hit = document.elementFromPoint(x, y);
      if (hit && !control.contains(hit) && !hit.contains(control)) {
        covered.push(`${name} by ${hit.outerHTML.slice(0, 90)}`);
      }
      if (!scrolls && (bottom > innerHeight || right > innerWidth || left < 0 || top < 0)) {
        covered.push(`half out of the window: ${name}`);
      }
    }
    return { covered, count };
  });
  expect(count).toBeGreaterThan(8);
  expect(covered, where).toEqual([]);
}
