import { describe, expect, it } from 'vitest';
import { createActor } from '../../../src/document/scene.ts';
import { jointSection } from '../../../src/evaluation/comparison/joint-section.ts';
import { type Sweep, sweepOf } from '../../../src/evaluation/comparison/sweep.ts';
import { sweepRows } from '../../../src/evaluation/comparison/sweep-rows.ts';
import { type TurnRange, turnRanges } from '../../../src/evaluation/comparison/turn-range.ts';
import type { MethodId } from '../../../src/skinning/method.ts';
import { kernelById, methods } from '../../../src/skinning/registry.ts';
import { together } from '../../fixtures/solids.ts';
import { straightTube, twistingTube } from '../../fixtures/twisting-tube.ts';
import { fullPool } from '../../support/kernels.ts';

const tube = await twistingTube();
const pool = fullPool();
const joint = 2;

async function swept(axis: 0 | 1 | 2, ids: readonly MethodId[], steps: number): Promise<Sweep> {
  const range = turnRanges(tube.skeleton, joint).find((each) => each.axis === axis)!;
  const actor = createActor(1, tube, 'linear-blend');
  for (const method of ids) await pool.kernels.loadFor({ ...actor, method });
  const work = sweepOf(pool, actor, ids, range, steps);
  for (let result = work.next(); ; result = work.next()) if (result.done) return result.value;
}

/** A sweep over half a turn each way by linear blend, at every 30°. */
const [bend, twist] = await Promise.all(
  ([0, 1] as const).map((axis) => swept(axis, ['linear-blend'], 12)),
);

describe('a sweep of the candy wrapper', () => {
  it('goes over half a turn each way where the joint has no limits', () => {
    expect(twist!.angles).toHaveLength(13);
    expect(twist!.angles[0]).toBe(-Math.PI);
    expect(twist!.angles[12]).toBe(Math.PI);
  });

  it('has 1 at rest, and the section that the formula of linear blend gives elsewhere', () => {
    // At the joint both weights are 1/2: the blend of a turn by θ with none shrinks by cos(θ/2) what
    // is across the axis. That is both directions of the section of a twist, and one of a bend's.
    for (const [i, angle] of twist!.angles.entries()) {
      const half = Math.cos(angle / 2);
      expect(twist!.curves[0]!.sections[i]).toBeCloseTo(half ** 2, 5);
      expect(bend!.curves[0]!.sections[i]).toBeCloseTo(half, 5);
    }
    expect(twist!.curves[0]!.volumes[6]).toBeCloseTo(1, 6);
  });

  /** Volumes as parts of that at rest, computed apart from Sinew. */
  const expected: Partial<Record<MethodId, readonly [bend90: number, twist150: number]>> = {
    'linear-blend': [0.916, 0.689],
    'dual-quaternion': [0.999, 0.997],
    'centers-of-rotation': [0.994, 0.997],
  };

  it.each(methods.filter(({ id }) => expected[id]).map(({ id }) => id))(
    'leaves the volumes that the formulas of %s give',
    async (id) => {
      const [bent, twisted] = await Promise.all(
        ([0, 1] as const).map((axis) => swept(axis, [id], 12)),
      );
      const at = (sweep: Sweep, degrees: number): number =>
        sweep.curves[0]!.volumes[
          sweep.angles.findIndex((a) => Math.abs(a - (degrees * Math.PI) / 180) < 1e-9)
        ]!;
      const [bend90, twist150] = expected[id]!;
      expect(Math.abs(at(bent!, 90) - bend90)).toBeLessThan(0.005);
      expect(Math.abs(at(twisted!, 150) - twist150)).toBeLessThan(0.005);
    },
  );

  it('sweeps several methods together as each alone', async () => {
    const both = await swept(1, ['rigid', 'linear-blend'], 12);
    expect(both.curves.map(({ method }) => method)).toEqual(['rigid', 'linear-blend']);
    expect(both.curves[1]).toEqual(twist!.curves[0]);
  });

  it('stands in a table with a row for each angle', () => {
    const [head, ...rows] = sweepRows(twist!);
    expect(head).toEqual(['degrees', 'lbs volume / rest', 'lbs section / rest']);
    expect(rows.map(([degrees]) => degrees)).toEqual(twist!.angles.map((_, i) => 30 * i - 180));
    expect(rows[6]).toEqual([0, 1, 1]);
    expect(kernelById('linear-blend').short).toBe('lbs');
  });

  it('says how much is done, and ends early without harm', () => {
    const range = turnRanges(tube.skeleton, joint)[0]!;
    const work = sweepOf(pool, createActor(1, tube, 'linear-blend'), ['linear-blend'], range, 3);
    // What is found once for the mesh comes first.
    for (let part = 0; part < 2; part++) expect(work.next().value).toBe(0);
    expect(work.next().value).toBe(0.25);
    expect(work.next().value).toBe(0.5);
    expect(work.return(undefined as never).done).toBe(true);
    expect(work.next().done).toBe(true);
  });
});

describe('the section at a joint', () => {
  it('is that around the joint alone, where the plane cuts other parts too', async () => {
    const { points } = straightTube();
    const solids = [0, 3, -3].map((move) => {
      const { points: own, triangles } = straightTube();
      return { points: own.map(([x, y, z]) => [x! + move, y!, z!]), triangles };
    });
    const three = await twistingTube(together(...solids));
    const section = jointSection(three, joint)!;
    expect(section.from).toHaveLength(jointSection(tube, joint)!.from.length);
    expect(Math.max(...section.from, ...section.to)).toBeLessThan(points.length);
  });

  it('is none where the joint is outside, or the mesh is open there', async () => {
    const { points, triangles } = straightTube();
    const outside = points.map(([x, y, z]) => [x! + 3, y!, z!]);
    const beside = await twistingTube({ points: outside, triangles });
    expect(jointSection(beside, joint)).toBeNull();
    const slit = triangles.filter((corners) => !corners.includes(24 * 24));
    const open = await twistingTube({ points, triangles: slit });
    expect(jointSection(open, joint)).toBeNull();
  });
});

describe('the range of an axis', () => {
  const limited = (min: number, max: number) => {
    const { skeleton } = tube;
    const index = turnRanges(skeleton, joint)[0]!.index;
    const at = (values: Float64Array, value: number) =>
      values.map((v, i) => (i === index ? value : v));
    return { ...skeleton, qMin: at(skeleton.qMin, min), qMax: at(skeleton.qMax, max) };
  };
  const first = (ranges: readonly TurnRange[]) =>
    ranges.map(({ axis, from, to }) => [axis, from, to])[0];

  it('is that of its limits, and half a turn where there is none', () => {
    expect(first(turnRanges(limited(-0.5, 2), joint))).toEqual([0, -0.5, 2]);
    expect(first(turnRanges(limited(-0.5, Infinity), joint))).toEqual([0, -0.5, Math.PI]);
    expect(turnRanges(tube.skeleton, joint).map(({ axis }) => axis)).toEqual([0, 1, 2]);
  });

  it('leaves out an axis about which the joint cannot turn', () => {
    expect(first(turnRanges(limited(1, 1), joint))![0]).toBe(1);
  });
});
