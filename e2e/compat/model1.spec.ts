import { expect } from '@playwright/test';
import { largestDifference } from '../../tests/support/compare.ts';
import { drop, openView, setPose, verify, vertices } from '../support/app.ts';
import { model1Files, model1Poses, needModel1 } from '../support/shared.ts';
import { sharedPage, test } from '../support/test.ts';

needModel1();

// This compares Model1 of 6.837 on the page with vertices that were computed independently of
// Sinew.
const gpuBound = 2e-6;
const cpuBound = 1e-6;

test.describe('Model1, dropped on the page', () => {
  const page = sharedPage(async (page) => {
    await openView(page, 'model=tube');
    const [skel, obj, attach] = model1Files();
    // The files are recognized in any order and with endings in any case.
    await drop(page, [
      { ...attach!, name: 'MODEL1.ATTACH' },
      skel!,
      { ...obj!, name: 'model1.Obj' },
    ]);
  });

  test('is one whole character without problems', async () => {
    const { characters, problems } = await page().evaluate(() => ({
      characters: window.sinew.characters,
      problems: window.sinew.problems,
    }));
    expect(problems).toEqual([]);
    expect(characters).toHaveLength(1);
    expect(characters[0]).toMatchObject({ vertexCount: 13_336, triangleCount: 26_668 });
    expect(characters[0]!.joints).toHaveLength(18);
  });

  for (const which of [0, 1, 2]) {
    test(`has every vertex where the reference has it: pose ${which}`, async () => {
      const { pose, vertices: expected } = model1Poses()[which]!;
      expect(expected).toHaveLength(13_336 * 3);
      await setPose(page(), pose);
      expect(largestDifference(await vertices(page(), 'gpu'), expected)).toBeLessThan(gpuBound);
      expect(largestDifference(await vertices(page(), 'cpu'), expected)).toBeLessThan(cpuBound);
      expect(await verify(page())).toMatchObject({ identical: true, position: 0, normal: 0 });
    });
  }
});
