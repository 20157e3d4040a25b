import { describe, expect, it } from 'vitest';
import { clipFor, evaluateClip } from '../../src/core/motion/clip.ts';
import { isRotationChannel } from '../../src/core/motion/clip-parts.ts';
import { pinValues, slotOf } from '../../src/core/motion/targets.ts';
import { createActor } from '../../src/document/scene.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { EvaluationPool } from '../../src/evaluation/evaluation-pool.ts';
import { allThere } from '../support/kernels.ts';
import { bundledIds, readBundled, readMotionsOf } from '../support/bundled.ts';

const characters = new Map(
  await Promise.all(bundledIds.map(async (id) => [id, await readBundled(id)] as const)),
);
const motions = bundledIds.flatMap((id) =>
  readMotionsOf(id, characters.get(id)!).map(({ value, diagnostics }) => {
    return { id, clip: value!, name: value!.name, diagnostics };
  }),
);

/** In meters and radians. */
const same = 1e-9;

it('are a walk, a wave and an idle of the human, and a tail wag of the dog', () => {
  expect(motions.map(({ id, name }) => `${id} ${name}`)).toEqual([
    ...['human walk', 'human wave', 'human idle', 'dog tail-wag'],
  ]);
});

describe.each(motions)('the motion $name of the $id', ({ id, clip, diagnostics }) => {
  const character = characters.get(id)!;
  const valuesAt = (time: number): Float64Array => {
    const values = {
      q: character.skeleton.qRest.slice(),
      morphWeights: new Float64Array(character.morphs.length),
      pins: new Float64Array(character.skeleton.jointCount * pinValues.length),
    };
    evaluateClip(clipFor(clip, character), time, values);
    return values.q;
  };

  it('is read without a problem, and moves only what the character has, within its limits', () => {
    expect(diagnostics).toEqual([]);
    for (const channel of clip.channels) {
      if (isRotationChannel(channel) || !channel.target) throw new Error('a curve of a number');
      const slot = slotOf(channel.target, character)!;
      for (const { value } of channel.keys) {
        expect(value).toBeGreaterThanOrEqual(slot.minimum);
        expect(value).toBeLessThanOrEqual(slot.maximum);
      }
    }
  });

  it('ends as it begins', () => {
    const [first, last] = [valuesAt(clip.start), valuesAt(clip.end)];
    first.forEach((value, at) => expect(Math.abs(value - last[at]!)).toBeLessThan(same));
  });

  it('has no jump of speed where it begins again', () => {
    const step = 1e-4;
    const [a, b] = [valuesAt(clip.start), valuesAt(clip.start + step)];
    const [c, d] = [valuesAt(clip.end - step), valuesAt(clip.end)];
    a.forEach((value, at) => {
      expect(Math.abs(b[at]! - value - (d[at]! - c[at]!)) / step).toBeLessThan(0.05);
    });
  });
});

describe('the walk', () => {
  const human = characters.get('human')!;
  const { clip } = motions.find(({ name }) => name === 'walk')!;
  const actor = {
    ...createActor(1, { ...human, clips: [clip] }, 'linear-blend', { fitted: false }),
    clip: 0,
  };
  const evaluator = new Evaluator(actor, new EvaluationPool(allThere));
  const { skeleton } = human;

  it('bends no knee backward', () => {
    const knees = clip.channels.filter(({ target }) => {
      if (target?.of !== 'value' || target.axis !== 0) return false;
      return skeleton.names[target.joint]!.endsWith('lower leg');
    });
    expect(knees).toHaveLength(2);
    for (const { keys } of knees) {
      for (const { value } of keys) expect(value).toBeGreaterThan(0);
    }
  });

  it('has a foot on the floor at every frame, and none below it', () => {
    const count = Math.round((clip.end - clip.start) * clip.fps);
    for (let frame = 0; frame < count; frame++) {
      const { positions } = evaluator.evaluate(actor, frame / clip.fps).vertices();
      let lowest = Infinity;
      for (let i = 1; i < positions.length; i += 3) lowest = Math.min(lowest, positions[i]!);
      expect(Math.abs(lowest)).toBeLessThan(0.015);
    }
  });

  it('moves the foot that stands straight back at one speed, as the floor does', () => {
    const foot = skeleton.names.indexOf('Right toes') * 16;
    const count = 48;
    const places = Array.from({ length: count + 1 }, (_, at) => {
      const time = (2 / 16 + ((6 / 16) * at) / count) * (clip.end - clip.start);
      return evaluator.evaluate(actor, time).characterFromJoint.slice(foot + 12, foot + 15);
    });
    const [first, last] = [places[0]!, places.at(-1)!];
    const drifts = places.map(([x, , z], at) => {
      const part = at / count;
      return Math.hypot(x! - first[0]!, z! - (first[2]! * (1 - part) + last[2]! * part));
    });
    expect(Math.max(...drifts)).toBeLessThan(0.006);
    expect(first[2]! - last[2]!).toBeGreaterThan(0.5);
  });
});
