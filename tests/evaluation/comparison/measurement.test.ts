import { beforeAll, describe, expect, it } from 'vitest';
import { createActor } from '../../../src/document/scene.ts';
import { measure, measurementInput } from '../../../src/evaluation/comparison/measurement.ts';
import { stressOf } from '../../../src/evaluation/comparison/stress.ts';
import { stressPoses, usualRanges } from '../../../src/evaluation/comparison/stress-poses.ts';
import { sweepOf } from '../../../src/evaluation/comparison/sweep.ts';
import { turnRanges } from '../../../src/evaluation/comparison/turn-range.ts';
import { EvaluationPool } from '../../../src/evaluation/evaluation-pool.ts';
import { Kernels } from '../../../src/evaluation/kernels.ts';
import type { MethodId } from '../../../src/skinning/method.ts';

import { twistingTube } from '../../fixtures/twisting-tube.ts';
import { compiledSkinning } from '../../support/wasm-skinning.ts';

const tube = await twistingTube();
const actor = createActor(1, tube, 'linear-blend');
const methods: readonly MethodId[] = ['linear-blend', 'centers-of-rotation', 'delta-mush'];
const kernels = new Kernels();
const range = turnRanges(tube.skeleton, 2)[1]!;
const stress = { q: tube.skeleton.qRest, ranges: usualRanges, base: 1 };

beforeAll(async () => {
  kernels.wasm = await compiledSkinning();
  for (const method of methods) await kernels.loadFor({ ...actor, method });
});

function finished<T>(work: Generator<number, T>): T {
  for (let step = work.next(); ; step = work.next()) if (step.done) return step.value;
}

/** What another thread gets of a value. */
const passed = <T>(value: T): T => structuredClone(value);

describe('a measurement on another thread', () => {
  const pool = () => new EvaluationPool(kernels);

  it('sweeps to the same numbers', async () => {
    const plan = { range, steps: 6 };
    const input = measurementInput('sweep', plan, actor, methods, kernels);
    const parts: number[] = [];
    const sweep = passed(await measure(passed(input), (part) => parts.push(part)));
    expect(sweep).toEqual(finished(sweepOf(pool(), actor, methods, range, 6)));
    expect(parts.length).toBeGreaterThan(10);
    expect(parts.toSorted((a, b) => a - b)).toEqual(parts);
    expect(new Set(parts).size).toBe(parts.length);
    expect(parts.at(-1)).toBe(1);
  });

  it('puts joints under stress to the same numbers', async () => {
    const input = measurementInput('stress', stress, actor, methods, kernels);
    const suite = passed(await measure(passed(input), () => undefined));
    const poses = stressPoses(tube, tube.skin, tube.skeleton.qRest);
    expect(suite).toEqual(finished(stressOf(pool(), actor, methods, 1, poses)));
  });

  it('takes what was prepared, and prepares nothing anew', async () => {
    const input = measurementInput('stress', stress, actor, methods, kernels);
    const centers = input.prepared.get('centers-of-rotation') as Float32Array;
    const moved = new Map([['centers-of-rotation', centers.map((value) => value + 1)] as const]);
    const usual = await measure(input, () => undefined);
    const other = await measure({ ...input, prepared: moved }, () => undefined);
    expect(other.rows[0]!.numbers[0]).not.toEqual(usual.rows[0]!.numbers[0]);
  });

  it('gets no pictures and clips, which would be copied in vain', () => {
    const image = { name: 'a.png', textures: [], bytes: new Uint8Array(9) };
    const painted = { ...actor, character: { ...tube, images: [image] } };
    const input = measurementInput('stress', stress, painted, methods, kernels);
    expect(input.actor.character.images).toEqual([]);
  });
});
