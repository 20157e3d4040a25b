import { vec3 } from 'gl-matrix';
import { beforeAll, describe, expect, it } from 'vitest';
import { createActor } from '../../../src/document/scene.ts';
import {
  cuttingPlane,
  type PlaneDirection,
} from '../../../src/evaluation/comparison/cutting-plane.ts';
import {
  cornersOf,
  cornersOfParts,
  planeLines,
  pointOf,
} from '../../../src/evaluation/comparison/plane-lines.ts';
import { verticesBy } from '../../../src/evaluation/comparison/vertices-by.ts';
import type { Evaluation } from '../../../src/evaluation/evaluation.ts';
import { Evaluator } from '../../../src/evaluation/evaluator.ts';
import { turned, turnRanges } from '../../../src/evaluation/comparison/turn-range.ts';
import { twistingTube } from '../../fixtures/twisting-tube.ts';
import { fullPool } from '../../support/kernels.ts';

const tube = await twistingTube();
const pool = fullPool();
/** The joint in the middle of the tube, whose bones go along y. */
const joint = 2;
const facing = { toViewer: [0, 0, 1], up: [0, 1, 0] } as const;
const degree = Math.PI / 180;

/** The tube, bent by 90° about an axis, or straight. */
function posed(axis: 0 | 2, angle: number): Evaluation {
  const range = turnRanges(tube.skeleton, joint).find((each) => each.axis === axis)!;
  const actor = createActor(1, tube, 'linear-blend');
  const q = turned(tube.skeleton, actor.q, range, angle);
  return new Evaluator({ ...actor, q }, pool).evaluate({ ...actor, q }, 0);
}

const planeOf = (evaluation: Evaluation, direction: PlaneDirection, more = {}) =>
  cuttingPlane(evaluation, { joint, direction, turn: 0, offset: 0, ...more }, facing);

beforeAll(async () => {
  await pool.kernels.load('rigid');
  await pool.kernels.settled();
});

describe('the plane of a cutting figure', () => {
  it.each([0, 2] as const)('lies along both bones, however they are bent about axis %i', (axis) => {
    const { normal, origin, reach } = planeOf(posed(axis, 70 * degree), 'along');
    expect(Math.abs(normal[axis])).toBeCloseTo(1, 6);
    expect(vec3.distance([...origin], [0, 1, 0])).toBeLessThan(1e-6);
    expect(reach).toBeGreaterThan(0.5);
  });

  it('keeps its side while the bend goes through straight', () => {
    const sides = [-40, -2, 0, 2, 40].map((angle) => planeOf(posed(0, angle * degree), 'along'));
    for (const { normal } of sides) expect(normal[0]).toBeCloseTo(sides[0]!.normal[0], 6);
  });

  it('has right-handed axes whatever its direction, and moves and turns from there', () => {
    const evaluation = posed(0, 30 * degree);
    for (const direction of ['along', 'across', 'camera'] as const) {
      const { across, up, normal } = planeOf(evaluation, direction, { turn: 0.4, offset: 0.2 });
      const crossed = vec3.cross(new Float64Array(3), [...across], [...up]);
      expect(vec3.distance(crossed, [...normal])).toBeLessThan(1e-6);
    }
    const { normal, origin, reach } = planeOf(evaluation, 'camera', { offset: 0.5 });
    expect(normal).toEqual([0, 0, 1]);
    expect(origin[2]).toBeCloseTo(0.5 * reach, 6);
    const turnedPlane = planeOf(evaluation, 'camera', { turn: Math.PI / 2 });
    expect(turnedPlane.normal[0]).toBeCloseTo(1, 6);
  });
});

describe('the outlines in it', () => {
  it('are one ring of the straight tube across its bone, and one outline along it', () => {
    const evaluation = posed(0, 0);
    const { positions } = evaluation.vertices();
    for (const direction of ['across', 'along'] as const) {
      const plane = planeOf(evaluation, direction);
      const lines = planeLines(positions, cornersOf(tube.mesh), plane);
      expect(lines.map(({ isClosed }) => isClosed)).toEqual([true]);
      for (let i = 0; i < lines[0]!.places.length; i += 2) {
        const [right, rise] = lines[0]!.places.subarray(i, i + 2);
        const [x, y, z] = pointOf(plane, right!, rise!);
        const isOn =
          direction === 'across'
            ? Math.abs(y - 1)
            : Math.abs(plane.normal[0] * x + plane.normal[2] * z);
        expect(isOn).toBeLessThan(1e-6);
        expect(Math.hypot(x, z)).toBeLessThan(0.25 + 1e-6);
      }
    }
  });

  it('are of parts that come apart where they are rigid, and of one skin where it blends', () => {
    const evaluation = posed(0, 90 * degree);
    const plane = planeOf(evaluation, 'along');
    const rigid = verticesBy(evaluation, { method: 'rigid' }, pool.kernels);
    const parts = planeLines(rigid, cornersOfParts(tube.mesh, evaluation.skin), plane);
    expect(parts.map(({ isClosed }) => isClosed)).toEqual([false, false]);
    const blended = planeLines(evaluation.vertices().positions, cornersOf(tube.mesh), plane);
    expect(blended.map(({ isClosed }) => isClosed)).toEqual([true]);
  });
});
