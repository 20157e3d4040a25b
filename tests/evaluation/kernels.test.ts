import { effect, signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { createActor } from '../../src/document/scene.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { setMethod, setNormals } from '../../src/document/edits.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { EvaluationPool } from '../../src/evaluation/evaluation-pool.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { Kernels } from '../../src/evaluation/kernels.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';
import { fullPool } from '../support/kernels.ts';

const character = characterOfRig(Object.values(allRigs)[0]!());
const bent = () =>
  createActor(1, character, 'rigid', { q: character.skeleton.qRest.map(() => 0.4) });

describe('a method whose code is still loading', () => {
  it('is named as pending, linear blend replaces it meanwhile, and then it is used', async () => {
    const actor = bent();
    const evaluator = new Evaluator(actor, new EvaluationPool());
    expect(evaluator.pending).toEqual(['Rigid parts']);
    const stand = new Evaluator({ ...actor, method: 'linear-blend' }).vertices();
    expect(evaluator.vertices()).toEqual(stand);

    await expect.poll(() => evaluator.pending).toEqual([]);
    const rigid = new Evaluator(actor, fullPool()).vertices();
    expect(evaluator.vertices()).toEqual(rigid);
    expect(rigid).not.toEqual(stand);
  });

  it('notifies its readers, and `settled` waits for it', async () => {
    const session = new Session();
    const store = new Store();
    store.dispatch(openCharacter(null, character, 'linear-blend'));
    const evaluations = new Evaluations(store, session);
    const seen: string[] = [];
    effect(() => {
      for (const { method } of evaluations.all()) seen.push(method.id);
    });
    store.dispatch(setMethod(store.scene.value.actors[0]!.id, 'rigid'));
    await evaluations.settled();
    expect(seen).toEqual(['linear-blend', 'linear-blend', 'rigid']);
  });

  it('is reported once if it can’t be loaded, and not requested again', async () => {
    const told: unknown[] = [];
    const asked = signal(0);
    const kernels = new Kernels({
      complete: () => {
        asked.value++;
        return Promise.reject(new Error('gone'));
      },
      onFailed: (error) => told.push(error),
    });
    expect(kernels.of('rigid')).toBeUndefined();
    expect(kernels.of('rigid')).toBeUndefined();
    const actor = createActor(1, character, 'rigid');
    expect(kernels.pendingFor(actor)).toEqual(['Rigid parts']);
    await kernels.settled();
    await expect(kernels.load('rigid')).rejects.toThrow('gone');
    expect(kernels.pendingFor(actor)).toEqual([]);
    expect(kernels.of('rigid')).toBeUndefined();
    expect(told).toHaveLength(1);
    expect(asked.value).toBe(1);
  });

  it('keeps nothing else from being opened where it can’t be had', async () => {
    const store = new Store();
    store.dispatch(openCharacter(null, character, 'linear-blend'));
    const kernels = new Kernels({ complete: () => Promise.reject(new Error('gone')) });
    const evaluations = new Evaluations(store, new Session(), kernels);
    await evaluations.prepare(['rigid']);
    await evaluations.settled();

    store.dispatch(setMethod(store.scene.value.actors[0]!.id, 'rigid'));
    await expect(evaluations.settled()).rejects.toThrow('gone');
    expect(evaluations.all()[0]).toMatchObject({ pending: [], method: { id: 'linear-blend' } });
  });
});

describe('normals that are recomputed', () => {
  it('are named as pending while their code loads, and skinned ones stand in', async () => {
    const actor = createActor(1, character, 'linear-blend', {
      q: character.skeleton.qRest.map(() => 0.4),
      normals: 'angle',
    });
    const evaluator = new Evaluator(actor, new EvaluationPool());
    expect(evaluator.pending).toEqual(['mean of faces by angle']);
    const { normals } = new Evaluator({ ...actor, normals: 'blended' }).vertices();
    expect(evaluator.vertices().normals).toEqual(normals);
    await expect.poll(() => evaluator.pending).toEqual([]);
    expect(evaluator.vertices()).toEqual(new Evaluator(actor, fullPool()).vertices());
    expect(evaluator.vertices().normals).not.toEqual(normals);
  });

  it('change no position, and `settled` waits for them', async () => {
    const store = new Store();
    store.dispatch(openCharacter(null, character, 'linear-blend'));
    const evaluations = new Evaluations(store, new Session());
    const before = { ...evaluations.all()[0]!.revisions };
    store.dispatch(setNormals(store.scene.value.actors[0]!.id, 'faces'));
    await evaluations.settled();
    const [shown] = evaluations.all();
    expect(shown!.pending).toEqual([]);
    expect(shown!.revisions.vertices).toBe(before.vertices);
    expect(shown!.revisions.normals).not.toBe(before.normals);
  });
});
