import { expect, type Locator } from '@playwright/test';
import { tabs } from '../src/ui/tabs.ts';
import { drop, openApp, openJoint, openTab, setPose } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use(coarse);

// These tests find what a checker can detect of WCAG 2.2 AA: names, roles, contrast and the order
// of headings.
const page = sharedPage((page) => openApp(page, 'model=tube'));

test('the view describes its controls and what it shows, and undo is announced', async () => {
  const view = page().getByRole('application');
  await expect(view).toHaveAccessibleName('3D view: tube');
  await expect(view).toHaveAccessibleDescription(/Arrow keys orbit/);
  await page().getByRole('treeitem', { name: 'joint 02' }).click();
  await expect(view).toHaveAccessibleName('3D view: tube, joint 02');
  await setPose(page(), { joints: { 'joint 02': [0.5, 0, 0] } });
  await page().keyboard.press('Control+z');
  await expect(page().locator('output.notice')).toHaveText('Undid: Set the pose');
  await page().keyboard.press('Control+Shift+z');
  await expect(page().locator('output.notice')).toHaveText('Redid: Set the pose');
});

test('the page has no violations with an open joint and a listed problem, in light and dark colors', async () => {
  await openJoint(page(), 'joint 01', 'X');
  await drop(page(), [{ name: 'bad.skel', content: '0 0 zero -1\n' }]);
  await expect(page().locator('.problems')).toBeVisible();
  expect(await violations(page())).toEqual([]);
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), onlyColors)).toEqual([]);
});

// The test above opens panels, so the others need no page of their own. The insect has clips, morphs
// and a joint with locked angles.
test('every task and dialog has no violations, in light and dark colors', async () => {
  await page().evaluate(() => window.sinew.open('insect'));
  await openTab(page(), 'animate');
  await expect(page().getByRole('region', { name: 'Timeline' })).toBeVisible();
  await openJoint(page(), 'leg_l1_tibia', 'Z');
  await page().evaluate(() => window.sinew.seek(1));
  for (const { id } of tabs) {
    await openTab(page(), id);
    await expectNoViolations(id);
  }
  const dialog = page().getByRole('dialog');
  // The gallery has such a test of its own, with its pictures.
  for (const name of ['Show all keys', 'Search the commands']) {
    await page().getByRole('button', { name }).click();
    await expect(dialog).toBeVisible();
    await expect(dialog.locator('header + *')).toBeVisible();
    await expectNoViolations(name, 'dialog');
    await page().keyboard.press('Escape');
  }
});

test('the sheets of a narrow page have no violations', async () => {
  await page().setViewportSize({ width: 390, height: 800 });
  const panels = page().getByRole('navigation', { name: 'Panels' });
  // The sections of the other tasks are those of the wide page.
  for (const name of ['Characters', 'Pose']) {
    await panels.getByText(name).click();
    expect(await violations(page()), name).toEqual([]);
  }
});

// A window of 1280 × 1024 pixels at 400 % has this size.
test('at 400 % nothing is lost, and every control can be scrolled to', async () => {
  await page().setViewportSize({ width: 320, height: 256 });
  const panels = page().getByRole('navigation', { name: 'Panels' });
  // The first press on Animate shows the timeline, the second its sheet.
  for (const name of ['Characters', 'Pose', 'Deform', 'Animate', 'Animate']) {
    await panels.getByText(name).click();
    await expect(page().locator('[data-section]:not([hidden]):empty')).toHaveCount(0);
    expect(await page().evaluate(findUnreachable), name).toEqual([]);
  }
  for (const name of ['Show all keys', 'Search the commands']) {
    await page().getByRole('button', { name }).click();
    expect(await page().evaluate(findUnreachable), name).toEqual([]);
    await page().keyboard.press('Escape');
  }
  await page().setViewportSize({ width: 1280, height: 720 });
});

test('with forced colors, what is pressed, chosen or filled can be seen', async () => {
  await page().evaluate(() => window.sinew.open('tube'));
  await page().emulateMedia({ forcedColors: 'active', colorScheme: 'light' });
  await openTab(page(), 'pose');
  const background = (target: Locator) =>
    target.evaluate((element) => getComputedStyle(element).backgroundColor);
  const rows = page().getByRole('treeitem');
  await rows.nth(1).click();
  const views = page().getByRole('group', { name: 'What is shown' });
  const pairs: [Locator, Locator][] = [
    [views.locator('[aria-pressed=true]'), views.locator('[aria-pressed=false]')],
    [rows.nth(1), rows.nth(0)],
    [page().locator('.top [data-tab=pose]'), page().locator('.top [data-tab=deform]')],
    [page().locator('.actors li.selected'), page().locator('.top')],
  ];
  const slider = page().getByRole('slider', { name: 'joint 01 X' });
  pairs.push([slider.locator('.lil-fill'), slider]);
  for (const [chosen, other] of pairs) {
    expect(await background(chosen.first())).not.toBe(await background(other.first()));
  }
  await page().emulateMedia({ forcedColors: 'none' });
});

test('with reduced motion, nothing moves by itself', async () => {
  const title = page().locator('.controls .lil-title').getByText('Camera', { exact: true });
  /** The longest transition or animation of any element, in seconds, while a folder folds. */
  const longest = async (): Promise<number> => {
    await title.click();
    return page().evaluate(() => {
      const styles = Array.from(document.querySelectorAll('*'), (each) => getComputedStyle(each));
      const texts = styles.flatMap(({ transitionDuration, animationDuration }) => [
        ...transitionDuration.split(','),
        ...animationDuration.split(','),
      ]);
      return Math.max(...texts.map((text) => Number.parseFloat(text) || 0));
    });
  };
  expect(await longest()).toBeLessThan(0.001);
  await page().emulateMedia({ reducedMotion: 'no-preference' });
  expect(await longest(), 'which moves otherwise').toBeGreaterThan(0.1);
  await page().emulateMedia({ reducedMotion: 'reduce' });
});

async function expectNoViolations(where: string, within = 'body'): Promise<void> {
  expect(await violations(page(), { within }), where).toEqual([]);
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), { within, ...onlyColors }), `${where}, dark`).toEqual([]);
  await page().emulateMedia({ colorScheme: 'light' });
}

/** Runs in the page, and returns what can't be scrolled to where it can be pressed. */
function findUnreachable(): string[] {
  const lost: string[] = [];
  const { scrollWidth, clientWidth } = document.documentElement;
  if (scrollWidth > clientWidth) lost.push('the page scrolls sideways');
  const within = document.querySelector('dialog:modal') ?? document;
  const kinds = 'button, select, input, summary, [role=slider], [role=treeitem], [role=option]';
  for (const control of within.querySelectorAll(kinds)) {
    if (!control.checkVisibility({ visibilityProperty: true })) continue;
    const target = control.closest('label') ?? control;
    target.scrollIntoView({ block: 'center', inline: 'nearest' });
    const { left, right, top, bottom } = shownPart(target);
    const hit = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
    const isHit = hit !== null && (target.contains(hit) || hit.contains(target));
    if (left < -0.5 || right > innerWidth + 0.5 || !isHit) {
      const name = `${control.getAttribute('aria-label') ?? ''} ${control.textContent}`.trim();
      lost.push(`“${name}”: ${left}, ${top}, under ${hit?.outerHTML.slice(0, 60) ?? 'nothing'}`);
    }
  }
  return lost;

  /** The box of a control, as far as those around it do not cut it off. */
  function shownPart(control: Element): {
    left: number;
    right: number;
    top: number;
    bottom: number;
  } {
    let { left, right, top, bottom } = control.getBoundingClientRect();
    for (let at = control.parentElement; at && at !== document.body; at = at.parentElement) {
      if (getComputedStyle(at).overflow === 'visible') continue;
      const around = at.getBoundingClientRect();
      left = Math.max(left, around.left);
      right = Math.min(right, around.right);
      top = Math.max(top, around.top);
      bottom = Math.min(bottom, around.bottom);
    }
    return { left, right, top, bottom };
  }
}
