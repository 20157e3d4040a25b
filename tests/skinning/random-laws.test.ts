import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import type { SkinningMethod } from '../../src/skinning/method.ts';
import { poseVertices } from '../../src/skinning/pose-vertices.ts';
import { characterOfRig, qOfValues } from '../fixtures/character-of-rig.ts';
import { type Rig, transformsOf } from '../fixtures/rig.ts';
import { manyInfluences, randomValues } from '../fixtures/rigs.ts';
import { tube } from '../fixtures/tube.ts';
import type { Values } from '../reference/kinematics.ts';
import { multiply, transform } from '../reference/matrix.ts';
import { type Influence, skinningMatrix } from '../reference/skinned-vertex.ts';
import { boundingDiagonal, largestDifference, numbersAt } from '../support/compare.ts';
import { loadedKernels } from '../support/kernels.ts';
import { useOf } from '../support/method-use.ts';
import { randomBetween, randomSource, shuffled } from '../support/random.ts';
import { tolerances } from '../tolerances.ts';
import { skinRig } from './skin-rig.ts';

const { joints, rest } = manyInfluences();
const root = joints.findIndex(({ parent }) => parent === -1);
const { points, triangles } = seamedTube();
const bound = 2 * tolerances.skinning * boundingDiagonal(points);

/** What a row has beside positive weights that sum to 1: nothing, no weights, a negative one, … */
type RowKind = 'sound' | 'empty' | 'negative' | 'short' | 'long';

const soundKinds: readonly RowKind[] = ['sound', 'sound', 'empty', 'negative'];
const anyKinds: readonly RowKind[] = [...soundKinds, 'short', 'long'];

/** Rigs with 1 to 20 influences a point, in any order, and rows of these kinds. */
function rigs(kinds: readonly RowKind[], most = 20): fc.Arbitrary<Rig> {
  const row = fc.record({
    count: fc.integer({ min: 1, max: most }),
    kind: fc.constantFrom(...kinds),
    seed: fc.nat(),
  });
  const rows = fc.array(row, { minLength: points.length, maxLength: points.length });
  return rows.map((each) => ({ joints, rest, points, triangles, rows: each.map(rowOf) }));
}

function rowOf(choice: { count: number; kind: RowKind; seed: number }): readonly Influence[] {
  const { count, kind, seed } = choice;
  if (kind === 'empty') return [];
  const random = randomSource(seed);
  const chosen = shuffled(random, joints.length).slice(0, count);
  const raw = chosen.map(() => randomBetween(random, 0.2, 1));
  if (kind === 'negative' && count > 1) raw[0] = -0.1;
  const sum = raw.reduce((total, weight) => total + weight, 0);
  const scale = { short: 0.7, long: 1.4 }[kind as string] ?? 1;
  return chosen.map((joint, i) => [joint, (scale * raw[i]!) / sum]);
}

/** A tube of two meshes, which meet in a ring of points that each of them has. */
function seamedTube(): Pick<Rig, 'points' | 'triangles'> {
  const whole = tube(3, 5);
  const heightOf = (point: number): number => whole.points[point]![1]!;
  const upper = whole.triangles.filter((face) => face.every((point) => heightOf(point) >= 0.5));
  const seam = [...new Set(upper.flat())].filter((point) => heightOf(point) === 0.5);
  const copyOf = (point: number): number =>
    seam.includes(point) ? whole.points.length + seam.indexOf(point) : point;
  return {
    points: [...whole.points, ...seam.map((point) => whole.points[point]!)],
    triangles: whole.triangles.map((face) => (upper.includes(face) ? face.map(copyOf) : face)),
  };
}

/** Moves every point at rest, as rest layers do, and skins it. */
function skinMoved(
  rig: Rig,
  method: SkinningMethod,
  values: Values,
  offset: readonly number[],
): Float32Array {
  const { mesh, skin, skeleton } = characterOfRig(rig);
  const palette = new Float32Array(skin.paletteJoint.length * method.vec4sPerEntry(skin) * 4);
  method.packPalette(skin, jointMatrices(skeleton, qOfValues(skeleton, values)), palette);
  const moved = { ...mesh, positions: mesh.positions.map((value, i) => value + offset[i % 3]!) };
  const out = { positions: new Float32Array(mesh.positions.length), normals: null };
  poseVertices(method, mesh, moved, skin, palette, useOf(method, mesh, skin), out);
  return out.positions;
}

function check(arbitrary: fc.Arbitrary<Rig>, law: (rig: Rig) => void): void {
  fc.assert(fc.property(arbitrary, law), { numRuns: 20 });
}

describe.each(loadedKernels)('random rigs under $id', (method) => {
  it('are the mesh itself at rest', () => {
    check(rigs(soundKinds), (rig) => {
      const { positions } = skinRig(rig, method, rest);
      expect(largestDifference(positions, points.flat())).toBeLessThan(bound);
    });
  });

  it('follow a rigid motion of their root', () => {
    const moved = randomValues({ ...manyInfluences(), points }, 31);
    const values = rest.map((own, joint) => (joint === root ? moved[joint]! : own));
    check(rigs(soundKinds), (rig) => {
      const { characterFromJoint, jointFromBind } = transformsOf(rig, values);
      const motion = multiply(characterFromJoint[root]!, jointFromBind[root]!);
      const expected = points.flatMap((point) => transform(motion, point));
      expect(largestDifference(skinRig(rig, method, values).positions, expected)).toBeLessThan(
        bound,
      );
    });
  });

  // A method that looks at the whole posed mesh smooths over the border of two joints.
  it.skipIf('finish' in method)('move points of one joint as if they were part of it', () => {
    check(rigs(['sound'], 1), (rig) => {
      const values = randomValues(rig, 32);
      const transforms = transformsOf(rig, values);
      const expected = points.flatMap((point, index) =>
        transform(skinningMatrix(rig.rows[index]![0]![0], transforms), point),
      );
      expect(largestDifference(skinRig(rig, method, values).positions, expected)).toBeLessThan(
        bound,
      );
    });
  });

  it('do not depend on the order of influences', () => {
    check(rigs(anyKinds), (rig) => {
      const values = randomValues(rig, 33, 0.6);
      const reordered = { ...rig, rows: rig.rows.map((row) => row.toReversed()) };
      const [one, other] = [rig, reordered].map((each) => skinRig(each, method, values).positions);
      expect(largestDifference(one!, other!)).toBeLessThan(2 * bound);
    });
  });

  it('carry an offset at rest by one matrix a vertex, whatever the offset', () => {
    check(rigs(anyKinds), (rig) => {
      const values = randomValues(rig, 34, 0.6);
      const offsets = [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
        [0.5, -0.75, 0.25],
      ];
      const [still, x, y, z, moved] = offsets.map((each) => skinMoved(rig, method, values, each));
      for (let vertex = 0; vertex < points.length; vertex++) {
        const [p, px, py, pz] = [still!, x!, y!, z!].map((all) => numbersAt(all, vertex, 3));
        const expected = p!.map(
          (value, k) =>
            value + 0.5 * (px![k]! - value) - 0.75 * (py![k]! - value) + 0.25 * (pz![k]! - value),
        );
        expect(largestDifference(numbersAt(moved!, vertex, 3), expected)).toBeLessThan(2 * bound);
      }
    });
  });
});
