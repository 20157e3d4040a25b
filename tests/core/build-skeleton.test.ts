import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { buildSkeleton } from '../../src/core/build-skeleton.ts';
import type { JointParts } from '../../src/core/character-parts.ts';
import { DiagnosticLog, formatDiagnostic } from '../../src/core/diagnostics.ts';
import { defaultLimits, type Limits } from '../../src/core/limits.ts';
import { DofKind, type Skeleton } from '../../src/core/skeleton.ts';
import { firstRoot, subtreeEnd } from '../../src/core/subtree.ts';

function build(parents: readonly number[], limits: Limits = defaultLimits) {
  const log = new DiagnosticLog('a.skel');
  const joints = parents.map((parent, index): JointParts => {
    const place = { line: index + 1 };
    return { name: `${index}`, place, parent, restOffset: [index, 0, 0], dofs: [] };
  });
  const skeleton = buildSkeleton({ file: 'a.skel', joints }, log, limits);
  return { skeleton, messages: log.diagnostics.map(formatDiagnostic), log };
}

function built(parents: readonly number[]): Skeleton {
  const { skeleton, messages } = build(parents);
  if (!skeleton) throw new Error(messages.join('\n'));
  return skeleton;
}

describe('buildSkeleton', () => {
  it('sorts joints depth first, children in file order', () => {
    const skeleton = built([2, 0, -1, 2, 0, 3]);
    expect([...skeleton.sourceIndex]).toEqual([2, 0, 1, 4, 3, 5]);
    expect([...skeleton.jointOfSource]).toEqual([1, 2, 0, 4, 3, 5]);
    expect([...skeleton.parents]).toEqual([-1, 0, 1, 1, 0, 4]);
    expect([...skeleton.depths]).toEqual([0, 1, 2, 2, 1, 2]);
    expect(skeleton.names).toEqual(['2', '0', '1', '4', '3', '5']);
  });

  it('keeps roots in file order and finds the first', () => {
    const skeleton = built([1, -1, 3, -1]);
    expect([...skeleton.sourceIndex]).toEqual([1, 0, 3, 2]);
    expect(firstRoot(skeleton)).toBe(0);
    expect(subtreeEnd(skeleton, 0)).toBe(2);
    expect(subtreeEnd(skeleton, 2)).toBe(4);
  });

  it.each([
    [[-1, 1], '1 > 1', 2],
    [[1, 0, -1], '0 > 1 > 0', 1],
    [[-1, 0, 3, 4, 2], '2 > 3 > 4 > 2', 3],
    [[1, 2, 1, -1], '1 > 2 > 1', 2],
  ])('reports the cycle in %j with its path', (parents, path, line) => {
    const { skeleton, messages } = build(parents);
    expect(skeleton).toBeUndefined();
    expect(messages).toEqual([
      `a.skel:${line}: expected parents that lead to a root (-1), found "${path}"`,
    ]);
  });

  it('shortens a long cycle', () => {
    const parents = Array.from({ length: 20 }, (_, index) => (index + 1) % 20);
    const { messages } = build([...parents, -1]);
    expect(messages[0]).toContain('0 > 1 > 2 > 3 > 4 > 5 > 6 > 7 > …');
  });

  it('reports that there is no root', () => {
    const { skeleton, log } = build([1, 2, 0]);
    expect(skeleton).toBeUndefined();
    expect(log.diagnostics).toMatchObject([{ code: 'character/root', found: 'none among 3' }]);
  });

  it.each([[3], [-2], [0.5], [NaN]])('reports the parent %d of three joints', (parent) => {
    const { skeleton, log } = build([-1, parent, 0]);
    expect(skeleton).toBeUndefined();
    const found = `${parent}`;
    expect(log.diagnostics).toMatchObject([{ code: 'character/parent', line: 2, found }]);
  });

  it('takes as many joints as the limit and not one more', () => {
    const limits = { ...defaultLimits, jointCount: 3 };
    expect(build([-1, 0, 1], limits).skeleton?.jointCount).toBe(3);
    const { skeleton, log } = build([-1, 0, 1, 2], limits);
    expect(skeleton).toBeUndefined();
    expect(log.diagnostics).toMatchObject([{ code: 'character/limit', found: '4 joints' }]);
  });

  it('builds any forest, whatever the order of its joints', () => {
    fc.assert(
      fc.property(shuffledForest, (parents) => {
        const skeleton = built(parents);
        for (let joint = 0; joint < parents.length; joint++) {
          const source = skeleton.sourceIndex[joint]!;
          const parent = skeleton.parents[joint]!;
          expect(skeleton.jointOfSource[source]).toBe(joint);
          expect(parent).toBeLessThan(joint);
          expect(parent === -1 ? -1 : skeleton.sourceIndex[parent]).toBe(parents[source]);
          if (parent !== -1) expect(joint).toBeLessThan(subtreeEnd(skeleton, parent));
        }
      }),
    );
  });

  it('gives a skeleton or says why not, for any parents at all', () => {
    const anyParents = fc.array(fc.integer({ min: -3, max: 12 }), { maxLength: 10 });
    fc.assert(
      fc.property(anyParents, (parents) => {
        const { skeleton, messages } = build(parents);
        expect(skeleton === undefined).toBe(messages.length > 0);
        expect(skeleton !== undefined).toBe(
          parents.every((_, joint) => reachesRoot(joint, parents)),
        );
      }),
    );
  });
});

describe('degrees of freedom', () => {
  it("stand in joint order, and the file's pose is clamped to the limits", () => {
    const axis = [0, 0, 1] as const;
    const skeleton = buildSkeleton(
      {
        file: 'a.skel',
        joints: [
          joint(1, [{ kind: DofKind.hinge, axis, rest: [3], limits: [-1, 2] }]),
          joint(-1, [
            { kind: DofKind.ball, axis: [0, 0, 0] },
            { kind: DofKind.slide, axis, rest: [0.5] },
          ]),
        ],
      },
      new DiagnosticLog('a.skel'),
    )!;
    expect([...skeleton.dofStart]).toEqual([0, 2, 3]);
    expect([...skeleton.dofKind]).toEqual([DofKind.ball, DofKind.slide, DofKind.hinge]);
    expect([...skeleton.dofQ]).toEqual([0, 4, 5]);
    expect([...skeleton.qRest]).toEqual([0, 0, 0, 1, 0.5, 2]);
    expect([...skeleton.qMin].slice(4)).toEqual([-Infinity, -1]);
    expect([...skeleton.qMax].slice(4)).toEqual([Infinity, 2]);
  });

  function joint(parent: number, dofs: JointParts['dofs']): JointParts {
    return { name: '', parent, restOffset: [0, 0, 0], dofs };
  }
});

function reachesRoot(joint: number, parents: readonly number[]): boolean {
  let at = joint;
  for (let steps = 0; steps <= parents.length; steps++) {
    const parent = parents[at]!;
    if (parent === -1) return true;
    if (parent < -1 || parent >= parents.length) return false;
    at = parent;
  }
  return false;
}

/** Parents of a random forest whose joints are numbered randomly. */
const shuffledForest = fc
  .array(fc.nat(), { minLength: 1, maxLength: 40 })
  .chain((choices) => {
    const numbering = choices.map((_, index) => index);
    return fc.tuple(
      fc.constant(choices),
      fc.shuffledSubarray(numbering, { minLength: choices.length }),
    );
  })
  .map(([choices, numbering]) => {
    const parents: number[] = [];
    choices.forEach((choice, index) => {
      const earlier = (choice % (index + 1)) - 1;
      parents[numbering[index]!] = earlier === -1 ? -1 : numbering[earlier]!;
    });
    return parents;
  });
