import { expect } from '@playwright/test';
import { subtreeEnd } from '../../src/core/subtree.ts';
import { memoryFile } from '../../src/formats/file-entry.ts';
import { readCharacters } from '../../src/formats/read-characters.ts';
import { largestDifference } from '../../tests/support/compare.ts';
import { tolerances } from '../../tests/tolerances.ts';
import { drop, openView, setPose, verify, vertices } from '../support/app.ts';
import { kaito, kaitoPose, needKaito } from '../support/shared.ts';
import { sharedPage, test } from '../support/test.ts';

needKaito();

// This compares KAITO of the Virtual Mannequin on the page with vertices that were computed
// independently of Sinew, from the pose of the file alone. On the page, some joints copy the
// rotations of others as well, so that the points that follow these are left out here; the command
// line, which copies none, is compared at all points.
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
      const free = await unlinkedPoints();
      expect(free.length).toBeGreaterThan(7133 * 0.9);
      const wanted = pick(expected, free);
      for (const device of ['gpu', 'cpu'] as const) {
        const error = largestDifference(pick(await vertices(page(), device), free), wanted);
        test.info().annotations.push({ type: device, description: error.toExponential(1) });
        expect(error).toBeLessThan(tolerances.mannequinFiles);
      }
      expect(await verify(page())).toMatchObject({ identical: true, position: 0, normal: 0 });
    });
  }
});

/** The points whose joints are not moved by a joint that copies the rotation of another. */
async function unlinkedPoints(): Promise<number[]> {
  const files = kaito().map(({ name, content }) => memoryFile(name, Buffer.from(content)));
  const { characters } = await readCharacters(files);
  const { skeleton, skin, mesh, rotationLinks } = characters[0]!.character;
  const moved = new Set<number>();
  for (const { joint } of rotationLinks) {
    for (let each = joint; each < subtreeEnd(skeleton, joint); each++) moved.add(each);
  }
  return Array.from({ length: mesh.pointCount }, (_, point) => point).filter((point) => {
    const entries = skin.entries.subarray(skin.start[point], skin.start[point + 1]);
    return entries.every((entry) => !moved.has(skin.paletteJoint[entry]!));
  });
}

function pick(triples: Float32Array, points: readonly number[]): Float32Array {
  return Float32Array.from(
    points.flatMap((point) => [...triples.subarray(point * 3, point * 3 + 3)]),
  );
}
