import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import { type Actor, createActor, emptyScene } from '../../src/document/scene.ts';
import type { Evaluation } from '../../src/evaluation/evaluation.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { fullPool } from '../support/kernels.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';
import { swingOf } from '../fixtures/swing.ts';
import { withMorph } from '../fixtures/with-morph.ts';

interface Counts {
  joints: number;
  rest: number;
}

/** A character that counts how often its joints are placed and its rest mesh is computed. */
function countingCharacter(): { character: Character; counts: Counts } {
  const built = withMorph(characterOfRig(rotatedTree()));
  const { skeleton } = built;
  const counts = { joints: 0, rest: 0 };
  const character: Character = {
    ...built,
    clips: [swingOf(built)],
    skeleton: {
      ...skeleton,
      // Forward kinematics reads it once.
      get parents() {
        counts.joints++;
        return skeleton.parents;
      },
    },
    get morphs() {
      counts.rest++;
      return built.morphs;
    },
  };
  return { character, counts };
}

/** Reads every stage. */
function readAll(evaluation: Evaluation): void {
  evaluation.vertices();
  evaluation.bounds();
}

function copiesOf(character: Character, count: number): Actor[] {
  return Array.from({ length: count }, (_, i) => createActor(1 + i, character, 'linear-blend'));
}

describe('evaluators of one pool', () => {
  it('compute equal results once, for copies in one pose', () => {
    const { character, counts } = countingCharacter();
    const actors = copiesOf(character, 20);
    const pool = fullPool();
    counts.rest = 0;
    const evaluators = actors.map((actor) => new Evaluator(actor, pool));
    evaluators.forEach(readAll);
    expect({ ...counts }).toEqual({ joints: 1, rest: 1 });
    expect(new Set(evaluators.map((each) => each.vertices())).size).toBe(1);

    const posed = actors.map((actor) => ({ ...actor, q: actor.q.map((value) => value + 0.1) }));
    evaluators.forEach((each, i) => readAll(each.evaluate(posed[i]!, 0)));
    expect({ ...counts }).toEqual({ joints: 2, rest: 1 });
  });

  it('share pose, joints and rest mesh under two methods, and no later stage', () => {
    const { character, counts } = countingCharacter();
    const [actor] = copiesOf(character, 1) as [Actor];
    const pool = fullPool();
    counts.rest = 0;
    const left = new Evaluator(actor, pool);
    const right = new Evaluator({ ...actor, method: 'rigid' }, pool);
    [left, right].forEach(readAll);
    expect({ ...counts }).toEqual({ joints: 1, rest: 1 });
    expect(right.characterFromJoint).toBe(left.characterFromJoint);
    expect(right.rest).toBe(left.rest);
    expect(right.revisions).toMatchObject({ pose: left.revisions.pose, rest: left.revisions.rest });
    expect(right.revisions.vertices).not.toBe(left.revisions.vertices);
  });

  it('belong to a scene, with those of a comparison beside them', async () => {
    const { character, counts } = countingCharacter();
    const store = new Store();
    store.dispatch({
      label: 'Add',
      apply: () => ({ ...emptyScene, actors: copiesOf(character, 3) }),
    });
    const evaluations = new Evaluations(store, new Session());
    await evaluations.settled(['rigid']);
    counts.rest = 0;
    const rigid = { deformation: { method: 'rigid', normals: 'blended' } } as const;
    const shown = [...evaluations.all(), ...evaluations.all(rigid)];
    expect(shown).toHaveLength(6);
    shown.forEach(readAll);
    expect({ ...counts }).toEqual({ joints: 1, rest: 1 });
    expect(new Set(shown.map((each) => each.vertices())).size).toBe(2);
  });

  it('give the same results as each would alone, whatever the others show', () => {
    const { character } = countingCharacter();
    const actors = copiesOf(character, 3);
    const step = fc.record({
      who: fc.nat(2),
      angle: fc.constantFrom(0, 0.25, 0.5),
      weight: fc.constantFrom(0, 1),
      clip: fc.constantFrom(null, 0),
      method: fc.constantFrom('linear-blend', 'rigid'),
      reads: fc.boolean(),
    });
    fc.assert(
      fc.property(fc.array(step, { maxLength: 12 }), (steps) => {
        const pool = fullPool();
        const shown = actors.map((actor) => ({ actor, time: 0 }));
        const evaluators = actors.map((actor) => new Evaluator(actor, pool));
        for (const { who, angle, weight, clip, method, reads } of steps) {
          const q = actors[who]!.q.map((value) => value + angle);
          const morphWeights = Float64Array.of(weight);
          shown[who] = { actor: { ...actors[who]!, q, morphWeights, clip, method }, time: angle };
          evaluators[who]!.evaluate(shown[who].actor, angle);
          if (reads) readAll(evaluators[who]!);
        }
        evaluators.forEach((evaluator, i) => {
          const { actor, time } = shown[i]!;
          const alone = new Evaluator(actor, fullPool()).evaluate(actor, time);
          expect(evaluator.pose).toEqual(alone.pose);
          expect(evaluator.palette).toEqual(alone.palette);
          expect(evaluator.vertices()).toEqual(alone.vertices());
          expect(evaluator.bounds()).toEqual(alone.bounds());
        });
      }),
      { numRuns: 30 },
    );
  });

  it('hold nothing after they are disposed, and no pose that none of them shows', () => {
    const { character } = countingCharacter();
    const actors = copiesOf(character, 4);
    const pool = fullPool();
    const evaluators = actors.map((actor) => new Evaluator(actor, pool));
    evaluators.forEach(readAll);
    const { size } = pool.of(character);
    for (let moment = 0; moment < 5; moment++) {
      evaluators.forEach((each, i) => readAll(each.evaluate({ ...actors[i]!, clip: 0 }, moment)));
    }
    expect(pool.of(character).size).toBe(size);
    for (const evaluator of evaluators) evaluator.dispose();
    expect(pool.of(character).size).toBe(0);
  });
});
