import { AxeBuilder } from '@axe-core/playwright';
import { expect, type Page } from '@playwright/test';
import { drop, openApp } from './support/app.ts';
import { test } from './support/test.ts';

const rules = ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa'];

/** A page with something of everything: a joint open, a result, problems. */
async function fill(page: Page): Promise<void> {
  await openApp(page);
  await page.getByRole('treeitem', { name: 'Left forearm' }).click();
  await page.getByRole('button', { name: 'Verify' }).click();
  await drop(page, [{ name: 'bad.skel', content: '0 0 0 -1\n1 x 0 0\n' }]);
}

async function expectNoViolations(page: Page): Promise<void> {
  const { violations } = await new AxeBuilder({ page }).withTags(rules).analyze();
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html ?? ''}`)).toEqual([]);
}

test.describe('axe finds nothing', () => {
  for (const colorScheme of ['light', 'dark'] as const) {
    test.describe(colorScheme, () => {
      test.use({ colorScheme });
      test('on a wide page', async ({ page }) => {
        await fill(page);
        await expectNoViolations(page);
        await page.getByRole('button', { name: 'Keys' }).click();
        await expectNoViolations(page);
      });
    });
  }

  test.describe('narrow', () => {
    test.use({ viewport: { width: 390, height: 800 }, hasTouch: true });
    test('with each drawer out', async ({ page }) => {
      await openApp(page).catch(() => undefined);
      await expectNoViolations(page);
      for (const name of ['Characters', 'Controls']) {
        await page.getByRole('button', { name, exact: true }).click();
        await expectNoViolations(page);
      }
    });
  });
});
