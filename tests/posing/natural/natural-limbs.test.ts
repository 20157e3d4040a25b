import { beforeAll, describe, expect, it } from 'vitest';
import type { Character } from '../../../src/core/character.ts';
import { naturesOf } from '../../../src/posing/natural/natures.ts';
import { readBundled } from '../../support/bundled.ts';
import { bendsOf, type Limb } from '../../support/natural-limbs.ts';

const forward = [0, 0, 1] as const;

const limbs: readonly Limb[] = ['Right', 'Left'].flatMap((side) => [
  {
    kind: 'arm',
    chain: [`${side} shoulder`, `${side} upper arm`, `${side} forearm`],
    end: `${side} hand`,
    forward,
  },
  {
    kind: 'leg',
    chain: [`${side} upper leg`, `${side} lower leg`],
    end: `${side} foot`,
    forward,
  },
]);

describe('the human', () => {
  let human: Character;

  beforeAll(async () => {
    human = await readBundled('human');
  });

  it.each(limbs)('bends as is natural, from rest and after twelve drags: $end', (limb) => {
    const { bends, missed } = bendsOf(human, limb, naturesOf(human));
    expect(Math.max(...bends.map(({ outOfPlane }) => outOfPlane))).toBeLessThan(15);
    expect(Math.min(...bends.map(({ bend }) => bend))).toBeGreaterThan(-5);
    expect(Math.max(...bends.map(({ twist }) => Math.abs(twist)))).toBeLessThan(90);
    expect(missed / bends.length).toBeLessThanOrEqual(0.01);
  });

  it('does not without its nature, so that the measure can fail', () => {
    const { bends } = bendsOf(human, limbs[0]!, [], 24);
    const aside = bends.filter(({ outOfPlane }) => outOfPlane > 15);
    expect(aside.length).toBeGreaterThan(bends.length / 5);
  });
});
