import { effect, signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import type { Preparation, PrepareControl } from '../../src/evaluation/preparation.ts';
import { Preparations } from '../../src/evaluation/preparations.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';
import { loadedKernel } from '../support/kernels.ts';

const method = loadedKernel('centers-of-rotation');

interface Job extends PrepareControl {
  readonly finish: (result: unknown) => void;
  readonly fail: (error: unknown) => void;
}

/** Preparations whose results the test gives, one job after the other. */
function prepared(pause?: () => Promise<void>) {
  const jobs: Job[] = [];
  const told: unknown[] = [];
  const preparations = new Preparations({
    prepare: (_method, _mesh, _skin, control) =>
      new Promise((finish, fail) => jobs.push({ ...control, finish, fail })),
    ...(pause && { pause }),
    onFailed: (error) => told.push(error),
  });
  const of = ({ mesh, skin }: Character): Preparation => preparations.of(method, mesh, skin);
  return { preparations, jobs, told, of };
}

const soon = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

describe('what a method prepares', () => {
  it('is computed once for equal skins of equal meshes, also when they are read again', async () => {
    const { jobs, of } = prepared();
    const [first, again] = [characterOfRig(rotatedTree()), characterOfRig(rotatedTree())];
    expect(again.skin).not.toBe(first.skin);
    expect(of(first).value).toBeUndefined();
    await soon();
    jobs[0]!.finish('centers');
    await of(first).load();
    expect([of(first).value, of(again).value]).toEqual(['centers', 'centers']);
    expect(of(again).isPending).toBe(false);
    expect(jobs).toHaveLength(1);
  });

  it('is another one as soon as a weight or a vertex is', async () => {
    const { of } = prepared();
    const { mesh, skin } = characterOfRig(rotatedTree());
    const weights = skin.weights.slice();
    weights[3]! += 1e-6;
    const positions = mesh.positions.slice();
    positions[7]! += 1e-6;
    const character = characterOfRig(rotatedTree());
    const own = of(character);
    expect(of({ ...character, skin: { ...skin, weights } })).not.toBe(own);
    expect(of({ ...character, skin: { ...skin }, mesh: { ...mesh, positions } })).not.toBe(own);
    await soon();
  });

  it('tells how far it is, and those who wait', async () => {
    const { preparations, jobs, of } = prepared();
    const preparation = of(characterOfRig(rotatedTree()));
    const seen: unknown[] = [];
    const stop = effect(() => {
      seen.push(preparation.value);
    });
    await soon();
    expect(preparations.running.value).toEqual([preparation]);
    jobs[0]!.onProgress(0.4);
    expect(preparation.part.value).toBe(0.4);
    jobs[0]!.finish('centers');
    await preparation.load();
    expect(seen).toEqual([undefined, 'centers']);
    expect(preparations.running.value).toEqual([]);
    stop();
    expect(preparation.value).toBe('centers');
  });

  it('is ended when nobody waits any more, and begins anew for the next one', async () => {
    const { preparations, jobs, of } = prepared();
    const preparation = of(characterOfRig(rotatedTree()));
    const isChosen = signal(true);
    const stop = effect(() => {
      if (isChosen.value) expect(preparation.value).not.toBe('late');
    });
    const settled = preparation.load();
    await soon();
    isChosen.value = false;
    expect(jobs[0]!.signal.aborted).toBe(true);
    expect(preparations.running.value).toEqual([]);
    jobs[0]!.finish('late');
    await settled;
    expect(preparation.isPending).toBe(true);

    isChosen.value = true;
    await soon();
    expect(jobs).toHaveLength(2);
    jobs[1]!.finish('centers');
    await soon();
    expect(preparation.value).toBe('centers');
    stop();
  });

  it('is not tried again for the same ones after it was canceled', async () => {
    const { preparations, jobs, told, of } = prepared();
    const preparation = of(characterOfRig(rotatedTree()));
    const isChosen = signal(true);
    let asked = 0;
    const stop = effect(() => {
      asked++;
      if (isChosen.value) expect(preparation.value).toBeUndefined();
    });
    await soon();
    preparations.cancel();
    await soon();
    expect(jobs).toHaveLength(1);
    expect(jobs[0]!.signal.aborted).toBe(true);
    expect([preparation.isPending, preparations.running.value, told]).toEqual([false, [], []]);
    expect(asked).toBeGreaterThan(1);

    isChosen.value = false;
    isChosen.value = true;
    await soon();
    expect(jobs).toHaveLength(2);
    stop();
  });

  it('is the last one while weights are dragged, and is computed after a pause, for the last weights', async () => {
    const pauses: (() => void)[] = [];
    const { preparations, jobs, of } = prepared(() => new Promise((go) => pauses.push(go)));
    const character = characterOfRig(rotatedTree());
    const first = of(character);
    void first.load();
    await soon();
    jobs[0]!.finish('first');
    await first.load();
    expect(pauses).toEqual([]);

    const { skin } = character;
    const dragged = (by: number): Character => {
      const weights = skin.weights.map((weight) => weight + by);
      return { ...character, skin: { ...skin, weights } };
    };
    const drag = [0.1, 0.2, 0.3].map(dragged);
    const at = signal(0);
    const seen: unknown[] = [];
    const stop = effect(() => {
      const preparation = of(drag[at.value]!);
      seen.push([preparation.value, preparation.isPending]);
    });
    await soon();
    at.value = 1;
    await soon();
    at.value = 2;
    await soon();
    pauses.forEach((go) => go());
    await soon();
    expect(jobs).toHaveLength(2);
    expect(preparations.running.value).toEqual([of(drag[2]!)]);
    jobs[1]!.finish('last');
    await of(drag[2]!).load();
    expect(seen).toEqual([...drag.map(() => ['first', true]), ['last', false]]);
    stop();
  });

  it('is nothing, not the last one, after the new one was canceled', async () => {
    const { preparations, jobs, of } = prepared();
    const character = characterOfRig(rotatedTree());
    void of(character).load();
    await soon();
    jobs[0]!.finish('first');
    await of(character).load();
    const { skin } = character;
    const other = {
      ...character,
      skin: { ...skin, weights: skin.weights.map((each) => each / 2) },
    };
    const stop = effect(() => expect(of(other).value).not.toBe('second'));
    await soon();
    expect(of(other).value).toBe('first');
    preparations.cancel();
    expect([of(other).value, of(other).isPending]).toEqual([undefined, false]);
    stop();
  });

  it('is reported once if it fails, and those who wait hear of it', async () => {
    const { preparations, jobs, told, of } = prepared();
    const preparation = of(characterOfRig(rotatedTree()));
    const waiting = preparation.load();
    await soon();
    jobs[0]!.fail(new Error('no worker'));
    await expect(waiting).rejects.toThrow('no worker');
    expect([preparation.value, preparation.isPending]).toEqual([undefined, false]);
    expect(told).toHaveLength(1);
    expect(jobs).toHaveLength(1);
    expect(preparations.running.value).toEqual([]);
  });
});
