import { expect } from 'vitest';
import { type BadInput, noSkel, readSkeleton } from './bad-input.ts';

const nested = (depth: number): string =>
  `${'balljoint a {offset 1 0 0 '.repeat(depth)}${'}'.repeat(depth)}`;
const wide = (count: number): string =>
  `balljoint a {${'balljoint b{offset 1 0 0}'.repeat(count - 1)}}`;

/** Checks the displayed name of a joint; the file's own name is kept for writing. */
function named(title: string, name: string, shown: string, warnings: string[] = []): BadInput {
  const text = `balljoint root { balljoint ${name} { offset 1 2 3 } }`;
  return readSkeleton(`B14 ${title}`, text, warnings, 2, ({ skeleton }) => {
    expect(skeleton.names).toEqual(['root', shown]);
    expect([...skeleton.restOffsets.subarray(3)]).toEqual([1, 2, 3]);
  });
}

const unnamed = 'expected a name, found "{" [skel/name]; it is shown by its number';
const skipped = 'it is skipped, with its numbers or its block';

/** B1 to B9, B13, B14, B25 to B28 and B30: nesting, names and offsets of joints. */
export const skelTrees: readonly BadInput[] = [
  noSkel(
    'B2 no balljoint',
    'joint a { }',
    ':1:1: expected "balljoint", found "joint" [skel/token]',
  ),
  readSkeleton('B3 no name', 'balljoint {\n}\n', [`:1:11: ${unnamed}`], 1, ({ skeleton }) => {
    expect(skeleton.names).toEqual(['joint 00']);
    expect(skeleton.fileNames).toEqual(['']);
  }),
  readSkeleton(
    'B3 no names, said once',
    'balljoint  {balljoint {offset 1 0 0}\nballjoint {}}',
    [`:1:12: ${unnamed}`],
    3,
  ),
  noSkel(
    'B4 no brace behind the name',
    'balljoint a offset 1 2 3',
    ':1:13: expected "{", found "offset" [skel/token]',
  ),
  noSkel(
    'B5 end within a joint',
    'balljoint a {\n balljoint elbow {\n',
    ':3:1: expected "}" for joint "elbow" opened at line 2, found "the end of the file" [skel/end]',
  ),
  noSkel(
    'B6 a brace too many',
    'balljoint a { } }',
    ':1:17: expected nothing after the root joint, found "}" [skel/token]',
  ),
  noSkel(
    'B6 a brace that opens nothing',
    'balljoint a { { } }',
    ':1:15: expected a property or a joint, found "{" [skel/token]',
  ),
  readSkeleton(
    'B7 two roots',
    'balljoint a {}\nballjoint b {offset 1 0 0}\nballjoint c {}',
    [':2:1: expected one root joint, found "another" [skel/root]; they are read as a forest'],
    3,
    ({ skeleton }) => expect([...skeleton.parents]).toEqual([-1, -1, -1]),
  ),
  readSkeleton('B8 as deep as may be', nested(1024), [], 1024),
  noSkel(
    'B8 one level deeper',
    nested(1025),
    ':1:26625: expected at most 1024 levels, found "balljoint" [skel/depth]',
  ),
  noSkel(
    'B8 100,000 levels',
    'balljoint a {\n'.repeat(100_000),
    ':1025:1: expected at most 1024 levels, found "balljoint" [skel/depth]',
  ),
  readSkeleton('B9 as many children as may be', wide(4096), [], 4096),
  noSkel(
    'B9 5,000 children',
    wide(5000),
    ':1:102389: expected at most 4096 joints, found "balljoint" [skel/limit]',
  ),
  {
    ...noSkel(
      'B9 more children than a smaller limit',
      wide(3),
      ':1:39: expected at most 2 joints, found "balljoint" [skel/limit]',
    ),
    limits: { jointCount: 2 },
  },
  readSkeleton(
    'B13 joints of one name',
    'balljoint knee { balljoint knee { offset 1 0 0 } balljoint knee { } }',
    [],
    3,
    ({ skeleton }) => {
      expect(skeleton.names).toEqual(['knee', 'knee (2)', 'knee (3)']);
      expect(skeleton.fileNames).toEqual(['knee', 'knee', 'knee']);
      expect([...skeleton.parents]).toEqual([-1, 0, 0]);
    },
  ),
  named('a property of every object', '__proto__', '__proto__'),
  named('a method of every object', 'toString', 'toString'),
  named('markup', '<svg/onload=alert(1)>', '<svg/onload=alert(1)>'),
  named('10,000 characters', 'x'.repeat(10_000), 'x'.repeat(256)),
  named('right to left', '\u202ea', '\u202ea'),
  named('emoji', '🦵🏽', '🦵🏽'),
  named('empty quotes', '""', '""'),
  {
    ...named('markup of two words', '<svg onload>', ''),
    messages: [
      'error: a.skel:1:33: expected "{", found "onload>" [skel/token]; the skeleton is not used',
    ],
    left: null,
  },
  readSkeleton(
    'B25 unknown words and their numbers, said once a word',
    'balljoint a { mass 3 mass 4\n pos 0 0 0 offset 1 2 3 }',
    [
      `:1:15: expected a word of this format, found "mass" [skel/unknown]; ${skipped}`,
      `:2:2: expected a word of this format, found "pos" [skel/unknown]; ${skipped}`,
    ],
    1,
    ({ skeleton }) => expect([...skeleton.restOffsets]).toEqual([1, 2, 3]),
  ),
  readSkeleton(
    'B25 an unknown block, with braces in it',
    'balljoint a { joint end { offset 9 9 9 { } } offset 1 2 3 }',
    [`:1:15: expected a word of this format, found "joint" [skel/unknown]; ${skipped}`],
    1,
    ({ skeleton }) => expect([...skeleton.restOffsets]).toEqual([1, 2, 3]),
  ),
  readSkeleton(
    'B25 an unknown block of 100,000 levels',
    `balljoint a { junk ${'{'.repeat(100_000)}${'}'.repeat(100_000)} }`,
    [`:1:15: expected a word of this format, found "junk" [skel/unknown]; ${skipped}`],
  ),
  {
    ...noSkel(
      'B25 an unknown block without end',
      'balljoint a { junk { { }',
      ':1:25: expected "}" for "{" of line 1, found "the end of the file" [skel/end]',
    ),
    messages: [
      `warning: a.skel:1:15: expected a word of this format, found "junk" [skel/unknown]; ${skipped}`,
      'error: a.skel:1:25: expected "}" for "{" of line 1, found "the end of the file" [skel/end]; the skeleton is not used',
    ],
  },
  readSkeleton(
    'B26 braces that touch names, all on one line',
    'balljoint a{offset 1 2 3 balljoint b{offset 4 5 6}}',
    [],
    2,
    ({ skeleton }) => expect([...skeleton.restOffsets]).toEqual([1, 2, 3, 4, 5, 6]),
  ),
  readSkeleton(
    'B27 comments',
    '// of the leg\nballjoint a { # hip\n/* offset 9 9 9\n*/ offset 1 2 3 // {\n}',
    [],
    1,
    ({ skeleton }) => expect([...skeleton.restOffsets]).toEqual([1, 2, 3]),
  ),
  noSkel(
    'B27 a comment without end',
    'balljoint a { }\n/* b',
    ':2:5: expected "*/", found "a comment from line 2 without end" [skel/end]',
  ),
  readSkeleton('B28 keywords in another case', 'BallJoint a { OFFSET 1 2 3 Pose 0 0 1 }', [
    ':1:1: expected "balljoint", found "BallJoint" [skel/case]; it is read as that',
    ':1:15: expected "offset", found "OFFSET" [skel/case]; it is read as that',
    ':1:28: expected "pose", found "Pose" [skel/case]; it is read as that',
  ]),
  readSkeleton('B30 words after the root', 'balljoint a { }\nthe end of it\n', [
    ':2:1: expected nothing after the root joint, found "the" [skel/trailing]; it is skipped',
  ]),
  readSkeleton('B30 a block after the root', 'balljoint a { }\nmaterials { a { } }\n', [
    ':2:1: expected nothing after the root joint, found "materials" [skel/trailing]; it is skipped',
  ]),
];
