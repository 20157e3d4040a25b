import { describe, expect, it } from 'vitest';
import { defaultLimits } from '../../../src/core/limits.ts';
import { readSkel } from '../../../src/formats/cse169/skel.ts';
import { legSkel } from '../../support/cse169-files.ts';
import { shown } from '../../support/diagnose.ts';
import { bytesOf } from '../../support/files.ts';

function read(content: string | Uint8Array, limits = defaultLimits) {
  const { value, diagnostics } = readSkel('a.skel', bytesOf(content), limits);
  return { joints: value?.joints, messages: shown(diagnostics) };
}

const effect = 'the skeleton is not used';
const [x, y, z] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

describe("readSkel of CSE169's skeletons", () => {
  it('numbers joints depth first, as they stand in the file', () => {
    const { joints } = read('balljoint a { balljoint b { balljoint c { } } balljoint d { } }');
    expect(joints?.map(({ name, parent }) => [name, parent])).toEqual([
      ...[
        ['a', -1],
        ['b', 0],
        ['c', 1],
        ['d', 0],
      ],
    ]);
  });

  it('has hinges in the order Z, Y, X, and slides before them on the root alone', () => {
    const { joints } = read('balljoint a { pose 1 2 3 balljoint b { pose 4 5 6 } }');
    expect(joints![1]!.dofs).toEqual([
      { kind: 1, axis: z, rest: [6] },
      { kind: 1, axis: y, rest: [5] },
      { kind: 1, axis: x, rest: [4] },
    ]);
    expect(joints![0]!.dofs.map(({ kind, axis }) => [kind, axis])).toEqual([
      [0, x],
      [0, y],
      [0, z],
      [1, z],
      [1, y],
      [1, x],
    ]);
  });

  // B29
  it('has the defaults of the assignment', () => {
    const { joints, messages } = read('balljoint r {}');
    expect(messages).toEqual([]);
    expect(joints).toMatchObject([{ name: 'r', fileName: 'r', parent: -1, restOffset: [0, 0, 0] }]);
    expect(joints![0]!.displayBox).toEqual([-0.1, -0.1, -0.1, 0.1, 0.1, 0.1]);
    expect(joints![0]!.dofs.slice(3).map(({ rest, limits }) => [rest, limits])).toEqual(
      [1, 2, 3].map(() => [[0], undefined]),
    );
  });

  it('reads offset, box, limits and pose of a joint, and skips what it does not know', () => {
    const { joints, messages } = read(legSkel);
    expect(joints).toHaveLength(3);
    expect(joints![0]).toMatchObject({ name: 'hip', restOffset: [0, 1, 0] });
    expect(joints![0]!.displayBox).toEqual([-0.1, -0.5, -0.1, 0.1, 0, 0.1]);
    expect(joints![0]!.dofs.slice(3)).toEqual([
      { kind: 1, axis: z, rest: [0.25] },
      { kind: 1, axis: y, rest: [0], limits: [0, 0] },
      { kind: 1, axis: x, rest: [0.5], limits: [-1, 2] },
    ]);
    expect(joints![1]!.dofs[0]).toEqual({ kind: 1, axis: z, rest: [0.75], limits: [-2, 2] });
    expect(joints![2]).toMatchObject({ parent: 1, restOffset: [0, -0.5, 0.1] });
    const skipped = 'it is skipped, with its numbers or its block';
    expect(messages).toEqual([
      `warning: a.skel:8:3: expected a word of this format, found "mass" [skel/unknown]; ${skipped}`,
      `warning: a.skel:9:3: expected a word of this format, found "joint" [skel/unknown]; ${skipped}`,
    ]);
  });

  it.each(['\n', '\r\n', '\r\r\n', '\r'])('reads lines that end with %j', (end) => {
    const { joints } = read(legSkel.replaceAll('\n', end));
    expect(joints).toEqual(read(legSkel).joints);
  });

  // B3, B13, B14
  it('shows every joint by a name of its own, and keeps the names of the file', () => {
    const text = ['knee', 'knee', '', 'knee (2)', '__proto__', '""', 'knee', '\u202ea', '']
      .map((name) => `balljoint ${name} {}`)
      .join('\n');
    const { joints } = read(text.replace('knee (2)', 'knee_(2)'));
    expect(joints?.map(({ name }) => name)).toEqual([
      ...['knee', 'knee (2)', 'joint 02', 'knee_(2)', '__proto__', '""', 'knee (3)', '\u202ea'],
      'joint 08',
    ]);
    expect(joints?.map(({ fileName }) => fileName)).toEqual([
      ...['knee', 'knee', '', 'knee_(2)', '__proto__', '""', 'knee', '\u202ea', ''],
    ]);
    const long = read(`balljoint ${'x'.repeat(10_000)} {}`).joints!;
    expect(long[0]!.name).toHaveLength(256);
  });

  it.each([
    // B7
    [
      'balljoint a {} balljoint b {}',
      '1:16: expected one root joint, found "another" [skel/root]; they are read as a forest',
    ],
    // B3
    ['balljoint { }', '1:11: expected a name, found "{" [skel/name]; it is shown by its number'],
    // B12
    [
      'balljoint a { offset 1 2 3 offset 4 5 6 }',
      '1:28: expected one "offset" a joint, found "another" [skel/duplicate]; the last one counts',
    ],
    // B15
    [
      'balljoint a { boxmin 1 0 0 boxmax 0 1 1 }',
      '1: expected boxmin of "a" below its boxmax, found "1 0 0 and 0 1 1" [skel/box]; they are swapped where they are not',
    ],
    // B19
    [
      'balljoint a { rotxlimit 1 -1 }',
      '1:27: expected rotxlimit with min below max, found "1 -1" [skel/limits]; they are swapped',
    ],
    // B23
    [
      'balljoint a { rotylimit -1 2 pose 0 3 0 }',
      '1: expected pose y of "a" within its limits, -1 to 2, found "3" [skel/range]; it is clamped to 2',
    ],
    // B24
    [
      'balljoint a { pose 90 0 0 }',
      '1: expected angles in radians for "a", found "90 0 0" [skel/degrees]; they are used as radians, more than a full turn',
    ],
    // B25
    [
      'balljoint a { pos 0 0 0 pos 1 1 1 pos }',
      '1:15: expected a word of this format, found "pos" [skel/unknown]; it is skipped, with its numbers or its block',
    ],
    // B28
    [
      'BallJoint a { }',
      '1:1: expected "balljoint", found "BallJoint" [skel/case]; it is read as that',
    ],
    // B30
    [
      'balljoint a { } the end',
      '1:17: expected nothing after the root joint, found "the" [skel/trailing]; it is skipped',
    ],
  ])('reads %j and warns', (text, message) => {
    const { joints, messages } = read(text);
    expect(messages).toContain(`warning: a.skel:${message}`);
    expect(joints?.length).toBeGreaterThan(0);
  });

  it('swaps corners and limits in the wrong order, and takes the last of two offsets', () => {
    const { joints } = read(
      'balljoint a { boxmin 1 0 0 boxmax 0 1 1 rotzlimit 2 -1 offset 1 1 1 offset 2 2 2 }',
    );
    expect(joints![0]!.displayBox).toEqual([0, 0, 0, 1, 1, 1]);
    expect(joints![0]!.dofs[3]!.limits).toEqual([-1, 2]);
    expect(joints![0]!.restOffset).toEqual([2, 2, 2]);
  });

  it.each([
    // B2
    ['joint a { }', '1:1: expected "balljoint", found "joint" [skel/token]'],
    // B4
    ['balljoint a offset 1 2 3', '1:13: expected "{", found "offset" [skel/token]'],
    // B5
    [
      'balljoint a {\n balljoint elbow {\n',
      '3:1: expected "}" for joint "elbow" opened at line 2, found "the end of the file" [skel/end]',
    ],
    // B6
    ['balljoint a { } }', '1:17: expected nothing after the root joint, found "}" [skel/token]'],
    ['balljoint a { { } }', '1:15: expected a property or a joint, found "{" [skel/token]'],
    // B10, B11
    [
      'balljoint a {\n offset 1 2\n pose 0 0 0 }',
      '3:2: expected a number for offset z, found "pose" [skel/number]',
    ],
    [
      'balljoint a { offset a b c }',
      '1:22: expected a number for offset x, found "a" [skel/number]',
    ],
    // B17, B18
    [
      'balljoint a { boxmax 1 1e30 1 }',
      '1:24: expected boxmax y within ±1e18, found "1e30" [skel/range]',
    ],
    [
      'balljoint a { boxmax NaN 1 1 }',
      '1:22: expected a number for boxmax x, found "NaN" [skel/number]',
    ],
    // B21
    [
      'balljoint a { rotxlimit 5 }',
      '1:27: expected a number for rotxlimit max, found "}" [skel/number]',
    ],
    // B27
    [
      'balljoint a { } /* b',
      '1:21: expected "*/", found "a comment from line 1 without end" [skel/end]',
    ],
    // B33
    [
      'balljoint a { pose 1.#QNAN 0 0 }',
      '1:20: expected a number for pose x, found "1.#QNAN" [skel/number]',
    ],
    [
      'balljoint a { offset 0,5 0 0 }',
      '1:22: expected a number for offset x with a decimal point, found "0,5" [skel/number]',
    ],
  ])('refuses %j', (text, message) => {
    expect(read(text)).toEqual({
      joints: undefined,
      messages: [`error: a.skel:${message}; ${effect}`],
    });
  });

  it('tells which block is not closed among those that it skips', () => {
    expect(read('balljoint a { junk { { }').messages.at(-1)).toContain(
      'error: a.skel:1:25: expected "}" for "{" of line 1, found "the end of the file" [skel/end]',
    );
  });

  // B1, B32, B34
  it.each([
    ['', 'file/empty'],
    ['\0', 'file/binary'],
    ['<!doctype html>', 'file/html'],
    [new Uint8Array([0xff, 0xfe, 0x62, 0]), 'file/encoding'],
    ['# nothing\n', 'skel/empty'],
    [' '.repeat(10 * 1024 * 1024), 'skel/empty'],
  ])('finds no joint in %#', (content, code) => {
    const { messages } = read(content);
    expect(messages).toHaveLength(1);
    expect(messages[0]).toContain(`[${code}]`);
  });

  // B8
  it('stops at a depth, without recursion', () => {
    const nested = (depth: number): string =>
      `${'balljoint a {'.repeat(depth)}${'}'.repeat(depth)}`;
    expect(read(nested(1024)).joints).toHaveLength(1024);
    expect(read(nested(1025)).messages[0]).toContain('expected at most 1024 levels');
    expect(read('balljoint a {'.repeat(100_000)).messages).toHaveLength(1);
    const braces = `balljoint a { junk ${'{'.repeat(100_000)}${'}'.repeat(100_000)} }`;
    expect(read(braces).joints).toHaveLength(1);
  });

  // B9
  it('takes any number of children up to the limit of joints', () => {
    const wide = (count: number): string => `balljoint a {${'balljoint b {}'.repeat(count - 1)}}`;
    expect(read(wide(4096)).joints).toHaveLength(4096);
    expect(read(wide(4097)).messages[0]).toContain('expected at most 4096 joints');
    expect(read(wide(3), { ...defaultLimits, jointCount: 2 }).joints).toBeUndefined();
  });

  // B16, B20, B22
  it('keeps boxes of no size, locked axes and wide limits as they are', () => {
    const { joints, messages } = read(
      'balljoint a { boxmin 1 1 1 boxmax 1 1 1 rotxlimit 1 1 pose 1 0 0 rotylimit -100000 100000 }',
    );
    expect(messages).toEqual([]);
    expect(joints![0]!.displayBox).toEqual([1, 1, 1, 1, 1, 1]);
    const limits = joints![0]!.dofs.slice(3).map((dof) => dof.limits);
    expect(limits).toEqual([undefined, [-100000, 100000], [1, 1]]);
  });

  // B26
  it('reads a joint on one line', () => {
    expect(read('balljoint a{offset 1 2 3}').joints).toMatchObject([{ restOffset: [1, 2, 3] }]);
  });

  // B35
  it('refuses a number of endless digits at once', () => {
    const { messages } = read(`balljoint a { offset ${'1'.repeat(100_000)} 0 0 }`);
    expect(messages).toHaveLength(1);
    expect(messages[0]).toContain('expected a number for offset x');
  });
});
