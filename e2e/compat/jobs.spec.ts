import { expect } from '@playwright/test';
import { largestDifference } from '../../tests/support/compare.ts';
import { vertices } from '../support/app.ts';
import { model1Files, needModel1 } from '../support/shared.ts';
import { doStudentsJob } from '../support/student.ts';
import { coarse, test } from '../support/test.ts';
import { posedModel1 } from './model1-oracle.ts';

needModel1();
test.use({ ...coarse, viewport: { width: 1000, height: 640 } });

/** The right elbow's place in the file. */
const rightElbow = '#14';

test('a student poses Model1 and saves its picture with eight presses', async ({ page }) => {
  await page.goto('./');
  await page.evaluate(() => window.sinew.ready);
  await page.evaluate(() => window.sinew.settled());
  expect(await doStudentsJob(page, model1Files())).toBeLessThanOrEqual(8);
  const expected = posedModel1({ joints: { [rightElbow]: [0, 0, 1.57] } });
  expect(largestDifference(await vertices(page, 'gpu'), expected)).toBeLessThan(2e-6);
});
