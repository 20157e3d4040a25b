import { describe, expect, it } from 'vitest';
import type { Ray } from '../../src/core/ray.ts';
import { noJoint } from '../../src/core/skin.ts';
import { pickSkin } from '../../src/posing/pick-skin.ts';
import { TriangleTree } from '../../src/posing/triangle-tree.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { type Rig } from '../fixtures/rig.ts';
import { rotatedTree, unitWeights } from '../fixtures/rigs.ts';
import { inverse, transform } from '../reference/matrix.ts';
import { randomBetween, randomSource } from '../support/random.ts';

type Triple = readonly [number, number, number];

/**
 * The oracle: solves the linear system a + u (b - a) + v (c - a) = o + t d for each triangle by
 * elimination, and reads the weights of its corners by joint of the file.
 */
function pickByElimination(rig: Rig, origin: readonly number[], direction: readonly number[]) {
  let best = { distance: Infinity, owner: -1 };
  for (const corners of rig.triangles) {
    const [a, b, c] = corners.map((point) => rig.points[point]!);
    const minus = (p: readonly number[], q: readonly number[]) => p.map((v, i) => v - q[i]!);
    const [e, f, rest] = [minus(b!, a!), minus(c!, a!), minus(origin, a!)];
    const rows = [0, 1, 2].map((i) => [e[i]!, f[i]!, -direction[i]!, 0]);
    let solution: number[];
    try {
      solution = transform(inverse([...rows, [0, 0, 0, 1]]), rest);
    } catch {
      continue;
    }
    const [u, v, t] = [solution[0]!, solution[1]!, solution[2]!];
    if (u < 0 || v < 0 || u + v > 1 || t < 0 || t >= best.distance) continue;
    const sums = rig.joints.map((_, joint) =>
      [1 - u - v, u, v].reduce((sum, part, corner) => {
        const row = rig.rows[corners[corner]!]!.filter(([of]) => of === joint);
        return sum + row.reduce((all, [, weight]) => all + part * weight, 0);
      }, 0),
    );
    best = { distance: t, owner: sums.indexOf(Math.max(...sums)) };
  }
  return best;
}

function randomRay(random: () => number): { origin: Triple; direction: Triple } {
  const triple = (low: number, high: number): Triple => [
    randomBetween(random, low, high),
    randomBetween(random, low, high),
    randomBetween(random, low, high),
  ];
  const [origin, aim] = [triple(-2, 2), triple(-0.2, 1)];
  const away = [aim[0] - origin[0], aim[1] - origin[1], aim[2] - origin[2]] as const;
  const length = Math.hypot(...away);
  return { origin, direction: [away[0] / length, away[1] / length, away[2] / length] };
}

describe('picking the skin', () => {
  it.each([rotatedTree, unitWeights])('finds the nearest triangle and its owner', (rigOf) => {
    const rig = rigOf();
    const { mesh, skin, skeleton } = characterOfRig(rig);
    const tree = new TriangleTree(mesh);
    const random = randomSource(11);
    let hits = 0;
    for (let i = 0; i < 400; i++) {
      const ray = randomRay(random);
      const expected = pickByElimination(rig, ray.origin, ray.direction);
      const found = pickSkin(mesh, skin, tree, ray);
      if (!found) {
        expect(expected.distance).toBe(Infinity);
        continue;
      }
      hits++;
      expect(found.distance).toBeCloseTo(expected.distance, 5);
      expect(found.joint).toBe(skeleton.jointOfSource[expected.owner]);
      expect(found.barycentric.reduce((a, b) => a + b)).toBeCloseTo(1, 12);
    }
    expect(hits).toBeGreaterThan(100);
  });

  it('hits the surface from within too', () => {
    const { mesh, skin } = characterOfRig(rotatedTree());
    const tree = new TriangleTree(mesh);
    const inside: Ray = { origin: [0.1, 0.5, 0.05], direction: [0, 0.6, 0.8] };
    expect(pickSkin(mesh, skin, tree, inside)).not.toBeNull();
  });

  it('gives no joint where the skin follows none, and nothing without a mesh', () => {
    const { mesh, skin } = characterOfRig(rotatedTree());
    const still = { ...skin, paletteJoint: skin.paletteJoint.map(() => noJoint) };
    const inside: Ray = { origin: [0.1, 0.5, 0.05], direction: [0, 0.6, 0.8] };
    expect(pickSkin(mesh, still, new TriangleTree(mesh), inside)?.joint).toBeNull();
    const empty = { ...mesh, indices: new Uint32Array(0) };
    expect(pickSkin(empty, skin, new TriangleTree(empty), inside)).toBeNull();
  });
});
