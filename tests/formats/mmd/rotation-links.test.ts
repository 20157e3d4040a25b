import { expect, it } from 'vitest';
import { rotationLinks } from '../../../src/formats/mmd/rotation-links.ts';

const plain = { type: 0, tail: -1, ikParent: -1 };

it('a bone of type 5 copies the whole rotation of its IK parent, one of type 9 a part of its tail', () => {
  expect(
    rotationLinks([
      plain,
      { type: 5, tail: -1, ikParent: 3 },
      { type: 9, tail: 3, ikParent: 50 },
      plain,
    ]),
  ).toEqual([
    { joint: 1, source: 3, ratio: 1 },
    { joint: 2, source: 3, ratio: 0.5 },
  ]);
});

it('a link to itself, to bone 0 or to no bone is none', () => {
  expect(
    rotationLinks([
      plain,
      { type: 5, tail: -1, ikParent: 1 },
      { type: 5, tail: -1, ikParent: 0 },
      { type: 9, tail: -1, ikParent: 50 },
      { type: 5, tail: -1, ikParent: 9 },
    ]),
  ).toEqual([]);
});
