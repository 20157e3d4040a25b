import { afterEach, describe, expect, it } from 'vitest';
import { createActor } from '../../src/document/scene.ts';
import { EvaluationPool } from '../../src/evaluation/evaluation-pool.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { deformationOf, kernels, normalWays } from '../../src/skinning/registry.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';
import { swingOf, turnsOf } from '../fixtures/swing.ts';
import { fullPool } from '../support/kernels.ts';
import { compiledSkinning } from '../support/wasm-skinning.ts';

const arrays = ['Float32Array', 'Float64Array', 'Uint16Array', 'Uint32Array'] as const;
const own = arrays.map((name) => globalThis[name]);

/** Counts every typed array that is created by its constructor from now on. */
function countArrays(): { made: number } {
  const count = { made: 0 };
  for (const name of arrays) {
    const counting: ProxyHandler<object> = {
      construct(target, parameters, newTarget) {
        count.made++;
        return Reflect.construct(target as new () => object, parameters, newTarget) as object;
      },
    };
    Object.assign(globalThis, { [name]: new Proxy(globalThis[name], counting) });
  }
  return count;
}

afterEach(() => {
  arrays.forEach((name, i) => Object.assign(globalThis, { [name]: own[i] }));
});

describe('playing', () => {
  const character = characterOfRig(rotatedTree());
  const playing = {
    ...createActor(1, { ...character, clips: [swingOf(character)] }, 'linear-blend'),
    clip: 0,
  };
  const turning = {
    ...createActor(1, { ...character, clips: [turnsOf(character)] }, 'linear-blend'),
    clip: 0,
  };

  it.each(kernels.map(({ id }) => id))('makes no array on the way to vertices by %s', (id) => {
    const state = { ...playing, ...deformationOf(id) };
    const evaluator = new Evaluator(state, fullPool());
    evaluator.evaluate(state, 0).vertices();
    const count = countArrays();
    for (let frame = 1; frame <= 10; frame++) evaluator.evaluate(state, frame / 30).vertices();
    expect(count.made).toBe(0);
  });

  it.each(normalWays.map(({ id }) => id))('makes none for normals that are %s', (normals) => {
    const state = { ...playing, normals };
    const evaluator = new Evaluator(state, fullPool());
    evaluator.evaluate(state, 0).vertices();
    const count = countArrays();
    for (let frame = 1; frame <= 10; frame++) evaluator.evaluate(state, frame / 30).vertices();
    expect(count.made).toBe(0);
  });

  it.each(kernels.map(({ id }) => id))('makes none in the WebAssembly kernel by %s', async (id) => {
    const state = { ...playing, ...deformationOf(id) };
    const pool = new EvaluationPool();
    await pool.kernels.load(id);
    pool.kernels.wasm = await compiledSkinning();
    const evaluator = new Evaluator(state, pool);
    evaluator.evaluate(state, 0).vertices();
    const count = countArrays();
    for (let frame = 1; frame <= 10; frame++) evaluator.evaluate(state, frame / 30).vertices();
    expect(count.made).toBe(0);
  });

  it('makes none in 3,600 frames of curves of values and of rotations', () => {
    const evaluator = new Evaluator(turning, fullPool());
    evaluator.evaluate(turning, 0).vertices();
    const count = countArrays();
    let moved = 0;
    const joint = character.skeleton.jointOfSource[0]!;
    const first = character.skeleton.dofQ[character.skeleton.dofStart[joint]!]!;
    for (let frame = 1; frame <= 3600; frame++) {
      evaluator.evaluate(turning, frame / 60).vertices();
      moved += Math.abs(evaluator.pose.q[first]!);
    }
    expect(moved).toBeGreaterThan(0);
    expect(count.made).toBe(0);
  });

  it('makes none if copies play in step, because they share what is computed', () => {
    const pool = new EvaluationPool();
    const evaluators = Array.from({ length: 3 }, () => new Evaluator(playing, pool));
    const show = (time: number) =>
      evaluators.forEach((each) => each.evaluate(playing, time).vertices());
    show(0);
    show(1 / 30);
    const count = countArrays();
    for (let frame = 2; frame <= 10; frame++) show(frame / 30);
    expect(count.made).toBe(0);
    new Float32Array(1);
    expect(count.made).toBe(1);
  });

  it('makes none for a hundred copies, each from a pose of its own', () => {
    const pool = new EvaluationPool();
    const copies = Array.from({ length: 100 }, (_, i) => ({
      ...playing,
      id: i + 1,
      q: playing.q.map((value, at) => value + 0.01 * i * Math.sin(at)),
    }));
    const evaluators = copies.map((copy) => new Evaluator(copy, pool));
    const show = (time: number) =>
      copies.forEach((copy, i) => evaluators[i]!.evaluate(copy, time).vertices());
    show(0);
    const count = countArrays();
    for (let frame = 1; frame <= 3; frame++) show(frame / 30);
    expect(count.made).toBe(0);
  });

  it('shares skeleton, mesh and weights among copies; each adds what is posed alone', () => {
    const pool = new EvaluationPool();
    const copies = Array.from({ length: 100 }, (_, i) => {
      const q = character.skeleton.qRest.map((value) => value + 0.01 * i);
      return new Evaluator({ ...createActor(i + 1, character, 'linear-blend'), q }, pool);
    });
    const [first] = copies;
    for (const copy of copies) {
      expect(copy.rest).toBe(first!.rest);
      expect(copy.skin).toBe(first!.skin);
    }
    const posed = copies.flatMap((copy) => {
      const { positions, normals } = copy.vertices();
      return [positions, normals, copy.palette, copy.characterFromJoint];
    });
    expect(new Set(posed.map(({ buffer }) => buffer)).size).toBe(4 * copies.length);
    const bytes = posed.slice(0, 4).reduce((sum, { byteLength }) => sum + byteLength, 0);
    const { vertexCount } = character.mesh;
    const { jointCount } = character.skeleton;
    expect(bytes).toBe(vertexCount * 24 + jointCount * (48 + 128));
  });
});
