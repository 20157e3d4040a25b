import { beforeAll, describe, expect, it } from 'vitest';
import type { Character } from '../../../src/core/character.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { ChainDrag, type ChainDragStart } from '../../../src/posing/ik/chain-drag.ts';
import { placeOf } from '../../../src/posing/ik/chain-problem.ts';
import { naturalLength } from '../../../src/posing/ik/chain.ts';
import { dls } from '../../../src/posing/ik/dls.ts';
import type { Vector3 } from '../../../src/posing/ik/problem.ts';
import { naturesInUse } from '../../../src/posing/natural/natures-in-use.ts';
import { readBundled } from '../../support/bundled.ts';
import { sixBalls } from './ik-rigs.ts';
import { play, turnsBetween } from './drag-path.ts';

let human: Character;
beforeAll(async () => {
  human = await readBundled('human');
});

/** A drag of a joint's origin, from the file's pose. */
function dragOf(name: string): ChainDragStart {
  const { skeleton } = human;
  const joint = skeleton.names.indexOf(name);
  return {
    ...{ skeleton, q: skeleton.qRest, joint, point: [0, 0, 0], held: [], solver: dls, seconds: 0 },
    count: naturalLength(skeleton, joint),
    natures: naturesInUse(human, { isOn: true, own: [] }),
  };
}

const arm = (): ChainDragStart => dragOf('Left hand');

/** The six balls, dragged at their end from a bent pose. */
function balls(): ChainDragStart {
  const { skeleton, goals } = sixBalls();
  const { joint, point } = goals[0]!;
  const q = skeleton.qRest.map((value, i) => (i % 3 === 0 ? 0.2 : value));
  const held = { held: [], natures: [], solver: dls, seconds: 0 };
  return { skeleton, q, joint, point, count: skeleton.jointCount, ...held };
}

/** Where a drag starts, where its chain begins, and how long the chain is. */
function placesOf({ skeleton, q, joint, point, count }: ChainDragStart) {
  const matrices = jointMatrices(skeleton, q);
  const path: number[] = [];
  for (let each = joint; path.length < count; each = skeleton.parents[each]!) path.unshift(each);
  const places = path.map((each) => placeOf(matrices, each, [0, 0, 0]));
  const start = placeOf(matrices, joint, point);
  const reach = [...places, start].reduce(
    (sum, place, i, all) => (i === 0 ? 0 : sum + distance(place, all[i - 1]!)),
    0,
  );
  return { start, begin: places[0]!, reach };
}

function distance(a: Vector3, b: Vector3): number {
  return Math.hypot(...a.map((value, i) => value - b[i]!));
}

function moved([x, y, z]: Vector3, by: readonly number[], scale: number): Vector3 {
  return [x + by[0]! * scale, y + by[1]! * scale, z + by[2]! * scale];
}

const chains = [
  ['the human’s arm', arm],
  ['six balls', balls],
] as const;

describe('a drag of a chain', () => {
  it('ends in the same pose at 20, 60 and 120 frames a second', () => {
    const drag = arm();
    const { start, reach } = placesOf(drag);
    const path = (seconds: number): Vector3 =>
      moved(start, [-0.5 * seconds, 0.2 * Math.sin(6 * seconds), 0.5 * seconds], reach);
    const [slow, usual, fast] = [20, 60, 120].map((rate) => play(drag, path, 0.5, rate).end.q);
    expect(Math.max(...turnsBetween(drag.skeleton, slow!, usual!))).toBeLessThan(1);
    expect(Math.max(...turnsBetween(drag.skeleton, fast!, usual!))).toBeLessThan(1);
    expect(Math.max(...turnsBetween(drag.skeleton, drag.q, usual!))).toBeGreaterThan(10);
    // At one rate bit for bit.
    expect(play(drag, path, 0.5, 60).end.q).toEqual(usual);
  });

  it.each([
    [1.6, 0.4, 1.2],
    [0.6, -1.2, 1.4],
    [0.2, 1.5, 0.4],
  ])('ends so at each rate out of reach too: %s, %s, %s', (...direction) => {
    const drag = arm();
    const { start, begin, reach } = placesOf(drag);
    const path = (seconds: number): Vector3 => {
      const wave = 0.2 * Math.sin(6 * seconds);
      return moved(
        start,
        [direction[0] * 2 * seconds + wave, direction[1] * 2 * seconds, direction[2] * 2 * seconds],
        reach,
      );
    };
    expect(distance(path(0.5), begin), 'is out of reach').toBeGreaterThan(reach);
    const [slow, usual, fast] = [20, 60, 120].map((rate) => play(drag, path, 0.5, rate).end.q);
    expect(Math.max(...turnsBetween(drag.skeleton, slow!, usual!))).toBeLessThan(1);
    expect(Math.max(...turnsBetween(drag.skeleton, fast!, usual!))).toBeLessThan(1);
  });

  it.each(chains)('in a loop and back drifts by at most 3°: %s', (_, begin) => {
    const drag = begin();
    const { start, reach } = placesOf(drag);
    const path = (seconds: number): Vector3 => {
      const angle = Math.PI * seconds;
      return moved(start, [Math.cos(angle) - 1, Math.sin(angle), Math.sin(angle)], 0.15 * reach);
    };
    const { end, moments } = play(drag, path, 2, 60);
    expect(Math.max(...turnsBetween(drag.skeleton, drag.q, end.q))).toBeLessThan(3);
    const farthest = moments.map(({ q }) => Math.max(...turnsBetween(drag.skeleton, drag.q, q)));
    expect(Math.max(...farthest)).toBeGreaterThan(10);
  });

  it.each(chains)(
    'follows a hand that moves by hundredths of the reach by at most 5° each: %s',
    (_, begin) => {
      const drag = begin();
      const { start, reach } = placesOf(drag);
      const path = (seconds: number): Vector3 => moved(start, [-0.4, 0.3, 0.3], seconds * reach);
      // The path is 0.58 reaches long, and so are 58 frames.
      const { moments } = play(drag, path, 1, 58);
      for (let i = 1; i < moments.length; i++) {
        const turns = turnsBetween(drag.skeleton, moments[i - 1]!.q, moments[i]!.q);
        expect(Math.max(...turns)).toBeLessThan(5);
      }
    },
  );

  it('brings the point to its target, and says how far it is where it can’t', () => {
    const drag = arm();
    const { start, begin, reach } = placesOf(drag);
    const near = play(drag, () => moved(start, [-0.2, 0.1, 0.2], reach), 0.1, 60).end;
    const place = placeOf(jointMatrices(drag.skeleton, near.q), drag.joint, [0, 0, 0]);
    expect(distance(place, near.target)).toBeLessThan(2e-3 * reach);
    expect(near.isApart).toBe(false);
    const target = moved(begin, [2, 0, 0], reach);
    const far = play(drag, () => target, 0.1, 60).end;
    expect(far.isApart).toBe(true);
    expect(far.residual).toBeGreaterThan(0.99 * reach);
    expect(far.residual).toBeLessThan(1.01 * reach);
  });

  it('ends at the hand when it is let go at once', () => {
    const drag = arm();
    const { start, reach } = placesOf(drag);
    const begun = new ChainDrag(drag);
    begun.aim(moved(start, [-0.2, 0.1, 0.2], reach), 0.01);
    const { q, residual } = begun.finish();
    expect(residual).toBeLessThan(2e-3 * reach);
    const place = placeOf(jointMatrices(drag.skeleton, q), drag.joint, [0, 0, 0]);
    expect(distance(place, moved(start, [-0.2, 0.1, 0.2], reach))).toBeCloseTo(residual, 9);
  });

  it('keeps all bits of a pose whose point is not moved', () => {
    const drag = arm();
    const { start } = placesOf(drag);
    const { end } = play(drag, () => start, 0.1, 60);
    expect(end.q).toEqual(drag.q);
  });

  it('eases from a shorter chain into a longer one', () => {
    const drag = { ...arm(), count: 2 };
    const { start, reach } = placesOf(drag);
    const target = moved(start, [0.3, 0.3, 0.3], reach);
    const short = play(drag, () => target, 0.1, 60).end;
    const long = new ChainDrag({ ...drag, count: 6 }, short.q);
    long.aim(target, 0.001);
    const moments = Array.from({ length: 60 }, (_, i) => long.advance((i + 1) / 60));
    expect(Math.max(...turnsBetween(drag.skeleton, short.q, moments[0]!.q))).toBeLessThan(3);
    expect(moments.at(-1)!.residual).toBeLessThan(short.residual);
  });

  it('moves a root without turning it, over feet that stay', () => {
    const drag = dragOf('Root');
    const { skeleton, q } = drag;
    const matrices = jointMatrices(skeleton, q);
    const held = ['Left foot', 'Right foot'].map((name) => {
      const joint = skeleton.names.indexOf(name);
      const target = placeOf(matrices, joint, [0, 0, 0]);
      return { joint, point: [0, 0, 0] as const, target, weight: 10 };
    });
    const { start } = placesOf(drag);
    const { end } = play({ ...drag, held }, () => moved(start, [0.02, -0.1, 0], 1), 0.3, 60);
    const after = jointMatrices(skeleton, end.q);
    for (const { joint, target } of held) {
      expect(distance(placeOf(after, joint, [0, 0, 0]), target)).toBeLessThan(0.01);
    }
    expect(distance(placeOf(after, drag.joint, [0, 0, 0]), end.target)).toBeLessThan(0.01);
    expect(turnsBetween(skeleton, q, end.q)[drag.joint]).toBeLessThan(1);
  });
});
