import fc from 'fast-check';
import { describe, expect, it, vi } from 'vitest';
import { includePositions, emptyBounds } from '../../src/core/bounds.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { type Actor, createActor } from '../../src/document/scene.ts';
import type { Evaluation } from '../../src/evaluation/evaluation.ts';
import { EvaluationPool } from '../../src/evaluation/evaluation-pool.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { deformationOf, kernels, normalWays } from '../../src/skinning/registry.ts';
import { fullPool, loadedKernels } from '../support/kernels.ts';
import { skinVertices } from '../support/skin-vertices.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';
import { withMorph } from '../fixtures/with-morph.ts';
import { compiledSkinning } from '../support/wasm-skinning.ts';

const characters = Object.values(allRigs).map((rig) => withMorph(characterOfRig(rig())));

function stateOf(which: number): Actor {
  return createActor(1 + which, characters[which % characters.length]!, 'linear-blend');
}

/** One edit for every kind of input to a character's evaluation. */
const edits: readonly ((state: Actor, amount: number) => Actor)[] = [
  (state, amount) => ({ ...state, q: state.q.map((value) => value + amount) }),
  (state, amount) => ({
    ...state,
    ...deformationOf(kernels[Math.abs(Math.trunc(amount * 100)) % kernels.length]!.id),
  }),
  (state, amount) => ({ ...state, normalizeWeights: amount > 0 }),
  (state, amount) => ({
    ...state,
    normals: normalWays[Math.abs(Math.trunc(amount * 100)) % normalWays.length]!.id,
  }),
  (state, amount) => ({ ...state, influences: amount > 1 ? null : amount > 0 ? 2 : 1 }),
  (state, amount) => ({ ...state, morphWeights: state.morphWeights.map(() => amount) }),
  (state) => state,
];

const steps = fc.array(
  fc.tuple(fc.nat(edits.length - 1), fc.double({ noNaN: true, min: -2, max: 2 })),
  { maxLength: 12 },
);

describe('an evaluation', () => {
  it('depends only on character and moment, whatever was shown before', () => {
    fc.assert(
      fc.property(fc.nat(characters.length - 1), steps, (which, chosen) => {
        let state = stateOf(which);
        const evaluator = new Evaluator(state, fullPool());
        for (const [edit, amount] of chosen) {
          state = edits[edit]!(state, amount);
          const shown = evaluator.evaluate(state, amount);
          // Only some stages are read; the skipped ones must be up to date when they are read
          // later.
          if (amount > 0) expectFresh(shown, state, amount);
        }
        expectFresh(evaluator.evaluate(state, 0), state, 0);
      }),
    );
  });

  it('agrees with the full computation on the CPU, for every method', async () => {
    for (const [which, character] of characters.entries()) {
      for (const method of loadedKernels) {
        const state = { ...stateOf(which), ...deformationOf(method.id) };
        const pool = fullPool();
        await pool.kernels.loadFor(state);
        const shown = new Evaluator(state, pool).evaluate(state, 0);
        const { positions } = skinVertices(character, character.skin, state, method);
        expect(shown.vertices().positions).toEqual(positions);
        const joints = jointMatrices(character.skeleton, state.q);
        expect(shown.characterFromJoint).toEqual(joints);
        const box = emptyBounds();
        includePositions(box, positions, character.mesh.vertexCount);
        for (let at = 12; at < joints.length; at += 16) {
          includePositions(box, joints.subarray(at, at + 3), 1);
        }
        if (character.mesh.pointCount > 0) expect(shown.bounds()).toEqual(box);
      }
    }
  });

  it('is the same with the WebAssembly kernel, for copies in other poses and shapes', async () => {
    const pool = new EvaluationPool();
    pool.kernels.wasm = await compiledSkinning();
    const deform = vi.spyOn(pool.kernels.wasm, 'deform');
    const first = stateOf(0);
    const second = { ...first, q: first.q.map((value) => value + 0.3) };
    const third = { ...second, morphWeights: first.morphWeights.map(() => 0.7) };
    const evaluators = [first, second, third].map((state) => new Evaluator(state, pool));
    evaluators.forEach((evaluator) => evaluator.vertices());
    evaluators.forEach((evaluator) => {
      const strict = new Evaluator(evaluator.state);
      expect(evaluator.vertices()).toEqual(strict.vertices());
    });
    expect(deform.mock.results.map(({ value }) => value as boolean)).toEqual([true, true, true]);
  });

  it('keeps the revisions and the arrays of stages whose inputs did not change', () => {
    const state = stateOf(0);
    const evaluator = new Evaluator(state, fullPool());
    const first = { ...evaluator.evaluate(state, 0).revisions };
    const { palette, characterFromJoint } = evaluator;
    expect(evaluator.evaluate({ ...state }, 7).revisions).toEqual(first);
    expect(evaluator.palette).toBe(palette);

    const equal = { ...state, q: state.q.slice(), morphWeights: state.morphWeights.slice() };
    expect(evaluator.evaluate(equal, 0).revisions).toEqual(first);

    const shaped = { ...state, morphWeights: state.morphWeights.map(() => 0.5) };
    const second = evaluator.evaluate(shaped, 0).revisions;
    expect([second.pose, second.palette]).toEqual([first.pose, first.palette]);
    expect(second.rest).toBeGreaterThan(first.rest);
    expect(second.vertices).toBeGreaterThan(first.vertices);

    const other = evaluator.evaluate({ ...shaped, method: 'rigid' }, 0).revisions;
    expect(other.pose).toBe(first.pose);
    expect(other.palette).toBeGreaterThan(first.palette);
    expect(evaluator.characterFromJoint).toBe(characterFromJoint);
  });

  it('never has a revision of another evaluator', () => {
    const seen = new Set<number>();
    for (let which = 0; which < 20; which++) {
      const state = stateOf(which);
      const { vertices } = new Evaluator(state, fullPool()).evaluate(state, 0).revisions;
      expect(seen).not.toContain(vertices);
      seen.add(vertices);
    }
  });

  it('gives a snapshot that does not change at the next moment', () => {
    const state = stateOf(0);
    const evaluator = new Evaluator(state, fullPool());
    const kept = evaluator.evaluate(state, 0).snapshot();
    const before = kept.q.slice();
    state.q.fill(0.5);
    evaluator.evaluate({ ...state, q: state.q.map((value) => value + 1) }, 0).vertices();
    expect(kept.q).toEqual(before);
  });
});

function expectFresh(shown: Evaluation, state: Actor, time: number): void {
  const fresh = new Evaluator(state, fullPool()).evaluate(state, time);
  expect(shown.pose).toEqual(fresh.pose);
  expect(shown.characterFromJoint).toEqual(fresh.characterFromJoint);
  expect(shown.palette).toEqual(fresh.palette);
  expect(shown.vertices()).toEqual(fresh.vertices());
  expect(shown.bounds()).toEqual(fresh.bounds());
}
