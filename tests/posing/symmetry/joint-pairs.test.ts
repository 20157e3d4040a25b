import { describe, expect, it } from 'vitest';
import type { Skeleton } from '../../../src/core/skeleton.ts';
import { jointPairs, noPartner } from '../../../src/posing/symmetry/joint-pairs.ts';
import { bundled } from './mirror-laws.ts';

/** The pairs by names, left first, and the joints of the plane and without partner. */
function table(skeleton: Skeleton) {
  const { partners, sides } = jointPairs(skeleton);
  const names = (joints: readonly number[]) => joints.map((joint) => skeleton.names[joint]!);
  const joints = Array.from(partners.keys());
  return {
    pairs: joints
      .filter((joint) => sides[joint] === 1)
      .map((joint) => names([joint, partners[joint]!]).join(' ↔ ')),
    center: names(joints.filter((joint) => partners[joint] === joint)),
    alone: names(joints.filter((joint) => partners[joint] === noPartner)),
  };
}

/** The same joints in the same places, with names that tell nothing. */
function nameless(skeleton: Skeleton): Skeleton {
  return { ...skeleton, names: skeleton.names.map((_, joint) => `joint ${joint}`) };
}

/** How many joints stand left of the plane, on it, and alone. */
const counts: Readonly<Record<string, readonly [pairs: number, center: number, alone: number]>> = {
  human: [12, 8, 0],
  mannequin: [12, 8, 0],
  dog: [9, 40, 0],
  panda: [10, 14, 0],
  insect: [17, 5, 0],
  tube: [0, 3, 0],
  hand: [0, 0, 26],
};

describe.each(Object.entries(counts))('the pairs of %s', (id, [pairs, center, alone]) => {
  it('are all found', async () => {
    const { skeleton } = await bundled(id);
    const found = table(skeleton);
    expect(Object.values(found).map(({ length }) => length)).toEqual([pairs, center, alone]);
    for (const pair of found.pairs) {
      const [left, right] = pair.split(' ↔ ');
      const expected = left!.replace('Left', 'Right').replace(/_l(?=\d|_|$)/, '_r');
      expect(right).toBe(expected);
      expect(right).not.toBe(left);
    }
    expectInvolution(skeleton);
  });
});

it.each(['human', 'mannequin', 'dog', 'insect', 'tube', 'hand'])(
  'names are not needed where places tell the same: %s',
  async (id) => {
    const { skeleton } = await bundled(id);
    const { partners, sides } = jointPairs(nameless(skeleton));
    expect([...partners]).toEqual([...jointPairs(skeleton).partners]);
    expect([...sides]).toEqual([...jointPairs(skeleton).sides]);
  },
);

it('pairs what stands in the plane itself by what hangs below it', async () => {
  const { skeleton } = await bundled('human');
  const [left, right] = ['Left hip', 'Right hip'].map((name) => skeleton.names.indexOf(name));
  expect(jointPairs(nameless(skeleton)).partners[left!]).toBe(right);
});

it('leaves a joint alone whose partner is missing', async () => {
  const { skeleton } = await bundled('human');
  const thumb = skeleton.names.indexOf('Left thumb');
  const offsets = skeleton.restOffsets.slice();
  offsets[thumb * 3 + 1]! += 0.5;
  const names = skeleton.names.map((name, joint) => (joint === thumb ? 'Left wing' : name));
  const changed = { ...skeleton, names, restOffsets: offsets };
  expect(table(changed).alone).toEqual(['Right thumb', 'Left wing']);
  expectInvolution(changed);
});

function expectInvolution(skeleton: Skeleton): void {
  const { partners, sides } = jointPairs(skeleton);
  partners.forEach((partner, joint) => {
    if (partner === noPartner) expect(sides[joint]).toBe(0);
    else {
      expect(partners[partner]).toBe(joint);
      expect(sides[partner]).toBe(partner === joint ? 0 : -sides[joint]!);
    }
  });
}
