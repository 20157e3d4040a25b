import { expect } from '@playwright/test';
import { largestDifference } from '../../tests/support/compare.ts';
import { tolerances } from '../../tests/tolerances.ts';
import { drop, openView, setPose, verify, vertices } from '../support/app.ts';
import { kaito, kaitoPose, needKaito } from '../support/shared.ts';
import { sharedPage, test } from '../support/test.ts';

needKaito();

// This compares KAITO of the Virtual Mannequin on the page with vertices that were computed
// independently of Sinew.
test.describe('KAITO, dropped on the page', () => {
  const page = sharedPage(async (page) => {
    await openView(page, 'model=tube');
    await drop(page, kaito());
  });

  test('is one whole character without problems', async () => {
    const { characters, problems } = await page().evaluate(() => ({
      characters: window.sinew.characters,
      problems: window.sinew.problems,
    }));
    expect(problems).toEqual([]);
    expect(characters).toMatchObject([{ vertexCount: 7133 }]);
    expect(characters[0]!.joints).toHaveLength(106);
    expect(characters[0]!.joints).toContain('左ひじ');
  });

  for (const which of [0, 1]) {
    test(`has every vertex where the reference has it: pose ${which}`, async () => {
      const { pose, vertices: expected } = kaitoPose(which);
      expect(expected).toHaveLength(7133 * 3);
      await setPose(page(), pose);
      for (const device of ['gpu', 'cpu'] as const) {
        const error = largestDifference(await vertices(page(), device), expected);
        test.info().annotations.push({ type: device, description: error.toExponential(1) });
        expect(error).toBeLessThan(tolerances.mannequinFiles);
      }
      expect(await verify(page())).toMatchObject({ identical: true, position: 0, normal: 0 });
    });
  }
});
