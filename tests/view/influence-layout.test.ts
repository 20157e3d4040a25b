import { describe, expect, it } from 'vitest';
import { largestInfluenceCount } from '../../src/core/skin.ts';
import {
  lanes,
  packAttributeInfluences,
  packTextureInfluences,
} from '../../src/view/influence-layout.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';

/** The entry and the weight of every influence of a render vertex, in order. */
type Influences = [number, number][];

describe.each(
  Object.entries(allRigs).map(([name, rig]) => ({ name, character: characterOfRig(rig()) })),
)('the influences of $name', ({ character: { mesh, skin } }) => {
  const expected = Array.from(mesh.pointOf, (point): Influences => {
    const [from, to] = [skin.start[point]!, skin.start[point + 1]!];
    return Array.from({ length: to - from }, (_, i) => [
      skin.entries[from + i]!,
      skin.weights[from + i]!,
    ]);
  });

  it('are all in the attributes, in order, padded with weight 0', () => {
    const pairs = Math.max(1, Math.ceil(largestInfluenceCount(skin) / lanes));
    const { entries, weights } = packAttributeInfluences(mesh, skin, pairs);
    expected.forEach((influences, vertex) => {
      const at = vertex * pairs * lanes;
      const packed = Array.from({ length: pairs * lanes }, (_, i) => [
        entries[at + i]!,
        weights[at + i]!,
      ]);
      expect(packed.slice(0, influences.length)).toEqual(influences);
      expect(packed.slice(influences.length).every(([, weight]) => weight === 0)).toBe(true);
    });
  });

  it('are all in the texture, in order, whatever their number', () => {
    const { ranges, texels } = packTextureInfluences(mesh, skin);
    expected.forEach((influences, vertex) => {
      const [from, to] = [ranges[vertex * 2]!, ranges[vertex * 2 + 1]!];
      const packed = Array.from({ length: to - from }, (_, i) => [
        texels[(from + i) * 2]!,
        texels[(from + i) * 2 + 1]!,
      ]);
      expect(packed).toEqual(influences);
    });
  });
});
