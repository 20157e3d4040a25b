import { describe, expect, it } from 'vitest';
import { readSkel } from '../../../src/formats/cse169/skel.ts';
import { legSkel } from '../../support/cse169-files.ts';
import { shown } from '../../support/diagnose.ts';
import { bytesOf } from '../../support/files.ts';

function read(content: string) {
  const { value, diagnostics } = readSkel('a.skel', bytesOf(content));
  return { joints: value?.joints, messages: shown(diagnostics) };
}

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
});
