import { beforeAll, expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import { naturesOf } from '../../src/posing/natural/natures.ts';
import { readContents, readOne } from '../support/files.ts';
import { bendsOf, type Limb } from '../support/natural-limbs.ts';
import { describeWithShared, modelFiles, sharedBytes } from './shared-material.ts';

/** Model1 of 6.837 stands a little turned. */
const aside = [0.34, 0, 0.94] as const;

const model: readonly Limb[] = ['Right', 'Left'].flatMap((side) => [
  {
    kind: 'arm',
    chain: [`${side} collarbone`, `${side} shoulder`, `${side} elbow`],
    forward: aside,
  },
  {
    kind: 'leg',
    chain: [`${side} leg`, `${side} knee`],
    end: `${side} foot`,
    forward: aside,
  },
]);

const kaito: readonly Limb[] = ['左', '右'].flatMap((side) => [
  {
    kind: 'arm',
    chain: [`${side}肩`, `${side}腕`, `${side}ひじ`],
    end: `${side}手首`,
    forward: [0, 0, 1],
  },
  {
    kind: 'leg',
    chain: [`${side}足`, `${side}ひざ`],
    end: `${side}足首`,
    forward: [0, 0, 1],
  },
]);

function expectNatural(character: Character, limb: Limb): void {
  const { bends, missed } = bendsOf(character, limb, naturesOf(character));
  expect(Math.max(...bends.map(({ outOfPlane }) => outOfPlane))).toBeLessThan(15);
  expect(Math.min(...bends.map(({ bend }) => bend))).toBeGreaterThan(-5);
  expect(Math.max(...bends.map(({ twist }) => Math.abs(twist)))).toBeLessThan(90);
  expect(missed / bends.length).toBeLessThanOrEqual(0.01);
}

describeWithShared('Model1 of 6.837', ['data/mit-6837/Model1.skel'], () => {
  let character: Character;

  beforeAll(async () => {
    character = await readOne(modelFiles('Model1'));
  });

  it.each(model)('bends as is natural: $chain', (limb) => {
    expectNatural(character, limb);
  });
});

describeWithShared('KAITO', ['data/pmd/KAITO.pmd'], () => {
  let character: Character;

  beforeAll(async () => {
    const read = await readContents({ 'KAITO.pmd': sharedBytes('data/pmd/KAITO.pmd') });
    character = read.characters[0]!.character;
  });

  it.each(kaito)('bends as is natural: $chain', (limb) => {
    expectNatural(character, limb);
  });
});
