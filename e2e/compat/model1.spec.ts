import { expect, type Locator } from '@playwright/test';
import type { PoseJson } from '../../src/formats/pose-json.ts';
import { boundingDiagonal, largestDifference, numbersAt } from '../../tests/support/compare.ts';
import { drop, getPose, openApp, openJoint, setPose, verify, vertices } from '../support/app.ts';
import { model1Files, model1Poses, needModel1 } from '../support/shared.ts';
import { coarse, sharedPage, test } from '../support/test.ts';
import { posedModel1 } from './model1-oracle.ts';

needModel1();

// This compares Model1 of 6.837 on the page with vertices that were computed independently of
// Sinew.
const gpuBound = 2e-6;
const cpuBound = 1e-6;

// A joint that carries many others: its name on the page and its number in the file.
const [joint, number] = ['Chest', '#1'];

test.describe('Model1, dropped on the page', () => {
  test.use({ ...coarse, viewport: { width: 1000, height: 600 } });
  const page = sharedPage(async (page) => {
    await openApp(page, 'model=tube');
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

  test('comes to the reference when the pointer drags a slider', async () => {
    const { pose, vertices: expected } = model1Poses()[0]!;
    const [angle, y, z] = pose.joints![number]!;
    const withAngle = (x: number): PoseJson => ({
      ...pose,
      joints: { ...pose.joints, [number]: [x, y, z] },
    });
    const before = await setPose(page(), withAngle(0));
    const undragged = await vertices(page(), 'gpu');
    const { slider, field } = await openJoint(page(), joint, 'X');

    await drag(slider, [0, 0.2, 1, angle]);
    const dragged = await getPose(page());
    const reached = dragged.joints![joint]![0];
    // A slider can reach the angle only to within a pixel.
    expect(Math.abs(reached - angle)).toBeLessThan(0.1);
    await expect(slider).toHaveAttribute('aria-valuetext', `${degrees(reached)}°`);
    const oracle = posedModel1(withAngle(reached));
    const diagonal = boundingDiagonal(
      Array.from({ length: 13_336 }, (_, i) => numbersAt(oracle, i, 3)),
    );
    const draggedVertices = await vertices(page(), 'gpu');
    expect(largestDifference(draggedVertices, oracle)).toBeLessThan(gpuBound * diagonal);
    // This shows that the test can fail: a slider that does nothing would be far from the result.
    expect(largestDifference(draggedVertices, undragged)).toBeGreaterThan(0.05);

    await field.fill(String(angle));
    await field.press('Enter');
    expect(largestDifference(await vertices(page(), 'gpu'), expected)).toBeLessThan(gpuBound);

    // The typed value and the drag are one step each.
    await page().keyboard.press('Control+z');
    expect(await getPose(page())).toEqual(dragged);
    await page().keyboard.press('Control+z');
    expect(await getPose(page())).toEqual(before);
    await page().keyboard.press('Control+Shift+z');
    expect(await getPose(page())).toEqual(dragged);
    expect(await vertices(page(), 'gpu')).toEqual(draggedVertices);
  });
});

/**
 * Presses on the slider at the first value, moves over the others, and releases at the last one.
 */
async function drag(slider: Locator, values: readonly number[]): Promise<void> {
  const { x, y, width, height } = (await slider.boundingBox())!;
  const { mouse } = slider.page();
  const moveTo = (value: number): Promise<void> =>
    mouse.move(x + (value / Math.PI + 1) * 0.5 * width, y + height / 2, { steps: 4 });
  await moveTo(values[0]!);
  await mouse.down();
  for (const value of values.slice(1)) await moveTo(value);
  await mouse.up();
}

function degrees(radians: number): number {
  return Math.round((radians * 1800) / Math.PI) / 10;
}
