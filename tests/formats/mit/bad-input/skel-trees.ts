import { bonesOf } from '../../../../src/core/bones.ts';
import { expect } from 'vitest';
import { type BadInput, all, type Left, meshOnly, skeletonOnly, withSkel } from './bad-input.ts';

function refused(title: string, text: string, message: string): BadInput {
  return { title, files: withSkel(text), messages: [`error: a.skel${message}`], left: meshOnly };
}

function accepted(title: string, text: string, left: Left, ...messages: string[]): BadInput {
  return { title, files: { 'a.skel': text }, messages, left };
}

const roots = 'expected parents that lead to a root (-1), found';
const chain = (count: number): string =>
  Array.from({ length: count }, (_, joint) => `0 1 0 ${joint - 1}\n`).join('');
const ring = Array.from({ length: 12 }, (_, i) => `0 1 0 ${i === 11 ? 1 : i + 2}\n`).join('');

/** A14 to A19, A24 and A26: the hierarchy of a `.skel`. */
export const skelTrees: readonly BadInput[] = [
  refused(
    'A14 parent of itself',
    '0 0 0 -1\n0 1 0 1\n0 1 0 0\n',
    `:2:7: ${roots} "1 > 1" [character/cycle]`,
  ),
  refused(
    'A15 two that are parents of each other',
    '0 0 0 -1\n0 1 0 2\n0 1 0 1\n',
    `:2:7: ${roots} "1 > 2 > 1" [character/cycle]`,
  ),
  {
    title: 'A15 long cycle, its path cut',
    files: { ...withSkel(`0 0 0 -1\n${ring}`), 'a.attach': `${'0 '.repeat(12)}\n`.repeat(4) },
    messages: [`error: a.skel:2:7: ${roots} "1 > 2 > 3 > 4 > 5 > 6 > 7 > 8 > …" [character/cycle]`],
    left: meshOnly,
  },
  refused(
    'A16 no root',
    '0 0 0 2\n0 1 0 0\n0 1 0 1\n',
    ': expected at least one root (parent -1), found "none among 3" [character/root]',
  ),
  accepted(
    'A17 two roots',
    '0 0 0 -1\n0 1 0 0\n1 0 0 -1\n',
    skeletonOnly,
    'warning: a.skel:3:7: expected one root (parent -1), found "2 roots" [skel/root]',
  ),
  {
    ...accepted('A18 child before its parent', '0 0 0 -1\n0 1 0 2\n0 1 0 0\n', skeletonOnly),
    check: ({ skeleton }) => expect([...skeleton.sourceIndex]).toEqual([0, 2, 1]),
  },
  {
    title: 'A19 root not first',
    files: withSkel('0 1 0 1\n0 0 0 -1\n0 1 0 0\n'),
    messages: [
      'warning: a.skel:2:7: expected the root to be the first joint, found "joint 1" [skel/root]',
    ],
    left: all,
    check({ skeleton, skin }) {
      // The first column is joint 1 of the file, even if that is a root.
      expect(skeleton.sourceIndex[skin.paletteJoint[skin.entries[0]!]!]).toBe(1);
    },
  },
  accepted('A24 chain as long as the limit', chain(4096), { ...skeletonOnly, joints: 4096 }),
  {
    title: 'A24 one joint past the limit',
    files: { ...withSkel(chain(4097)), 'a.attach': '1 0\n'.repeat(4) },
    messages: ['error: a.skel:4097:7: expected at most 4096 joints, found "more" [skel/limit]'],
    left: meshOnly,
  },
  accepted(
    'A26 all joints on one point',
    '1 2 3 -1\n0 0 0 0\n0 -0 0 1\n',
    skeletonOnly,
    'warning: a.skel: expected joints apart from each other, found "all 3 on one point" ' +
      '[character/coincident]',
  ),
  {
    ...accepted('A26 some joints on one point', '1 2 3 -1\n0 0 0 0\n0 1 0 1\n', skeletonOnly),
    check: (character) => expect(bonesOf(character).map(({ joint }) => joint)).toEqual([1, 2]),
  },
];
