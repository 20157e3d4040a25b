import fc from 'fast-check';
import { expect, it } from 'vitest';
import { buildCharacter } from '../../src/core/build-character.ts';
import type { RotationLink } from '../../src/core/character-parts.ts';
import { noPins } from '../../src/posing/pins/pin.ts';
import { plainNatures } from '../../src/posing/natural/nature-settings.ts';
import { applyRotationLinks } from '../../src/posing/rotation-links.ts';
import { layerInput } from '../support/layer-input.ts';

type Quaternion = readonly [number, number, number, number];

/** Three balls in a row; the file's order is the reverse, so that indices differ. */
function withLinks(rotationLinks: readonly RotationLink[]) {
  const ball = { kind: 2, axis: [0, 0, 0], rest: [0, 0, 0, 1] } as const;
  const joints = [0, 1, 2].map((index) => ({
    name: `bone ${index}`,
    parent: index === 2 ? -1 : index + 1,
    restOffset: [0, 1, 0] as const,
    dofs: [ball],
  }));
  return buildCharacter({
    name: 'linked',
    missing: [],
    skeleton: { file: 'a.pmd', joints },
    rotationLinks,
  }).value!;
}

const about = (x: number, y: number, z: number, angle: number): Quaternion => {
  const sine = Math.sin(angle / 2) / Math.hypot(x, y, z);
  return [x * sine, y * sine, z * sine, Math.cos(angle / 2)];
};

/** The rotations of the bones after the links, in the file's order. */
function linked(links: readonly RotationLink[], rotations: readonly Quaternion[]): number[][] {
  const character = withLinks(links);
  const { jointOfSource, dofStart, dofQ } = character.skeleton;
  const placeOf = (source: number): number => dofQ[dofStart[jointOfSource[source]!]!]!;
  const q = character.skeleton.qRest.slice();
  rotations.forEach((rotation, source) => q.set(rotation, placeOf(source)));
  const use = { character, clip: null, pins: noPins, natures: plainNatures };
  applyRotationLinks(...layerInput(use, q));
  return rotations.map((_, source) => [...q.subarray(placeOf(source), placeOf(source) + 4)]);
}

const still: Quaternion = [0, 0, 0, 1];
const angle = fc.double({ min: -3, max: 3, noNaN: true });

it('a link copies its part of a rotation, after the own one', () => {
  fc.assert(
    fc.property(angle, fc.constantFrom(0, 0.25, 0.5, 1), (turn, ratio) => {
      const links = [{ joint: 0, source: 2, ratio }];
      const [copied, , source] = linked(links, [still, still, about(1, 2, 3, turn)]);
      const part = about(1, 2, 3, ratio * turn);
      copied!.forEach((value, i) => expect(value).toBeCloseTo(part[i]!, 12));
      expect(source).toEqual([...about(1, 2, 3, turn)]);
      // About one axis, rotations add up.
      const [sum] = linked(links, [about(1, 2, 3, 0.1), still, about(1, 2, 3, turn)]);
      about(1, 2, 3, 0.1 + ratio * turn).forEach((value, i) => {
        expect(sum![i]).toBeCloseTo(value, 12);
      });
    }),
  );
});

it('links pass on what they copied, in the order of the file', () => {
  const links = [
    { joint: 1, source: 2, ratio: 0.5 },
    { joint: 0, source: 1, ratio: 0.5 },
  ];
  const [last] = linked(links, [still, still, about(0, 0, 1, 0.8)]);
  about(0, 0, 1, 0.2).forEach((value, i) => expect(last![i]).toBeCloseTo(value, 12));
});
