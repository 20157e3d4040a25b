import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Mesh } from '../../src/core/mesh.ts';
import { deltaMush } from '../../src/skinning/delta-mush.ts';
import { linearBlend } from '../../src/skinning/linear-blend.ts';
import { poseVertices } from '../../src/skinning/pose-vertices.ts';
import type { Character } from '../../src/core/character.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import type { MethodSettings, SkinningMethod, VertexStreams } from '../../src/skinning/method.ts';
import { bentTube } from '../fixtures/bent-tube.ts';
import { characterOfRig, qOfValues } from '../fixtures/character-of-rig.ts';
import type { Rig } from '../fixtures/rig.ts';
import { randomValues, rotatedTree, unitWeights } from '../fixtures/rigs.ts';
import { deltaMushed } from '../reference/delta-mush.ts';
import { readBundled } from '../support/bundled.ts';
import { boundingDiagonal, largestDifference, numbersAt } from '../support/compare.ts';
import { tolerances } from '../tolerances.ts';
import { skinRigByOracle } from './skin-rig.ts';

interface Options {
  readonly rest?: Mesh;
  readonly settings?: MethodSettings;
  readonly method?: SkinningMethod;
}

function posed(
  { mesh, skin, skeleton }: Character,
  q: Float64Array,
  { rest = mesh, settings = {}, method = deltaMush }: Options = {},
): VertexStreams {
  const palette = new Float32Array(skin.paletteJoint.length * 12);
  method.packPalette(skin, jointMatrices(skeleton, q), palette);
  const out = {
    positions: new Float32Array(mesh.vertexCount * 3),
    normals: new Float32Array(mesh.vertexCount * 3),
  };
  poseVertices(method, mesh, rest, skin, palette, { extra: undefined, settings }, out);
  return out;
}

/** A pose in which every joint is bent considerably. */
function bent({ skeleton }: Character): Float64Array {
  return skeleton.qRest.map((value, i) => value + (i < 3 ? 0 : 0.8 * Math.sin(i)));
}

function sizeOf({ mesh }: Character): number {
  const points = Array.from({ length: mesh.pointCount }, (_, i) => numbersAt(mesh.positions, i, 3));
  return boundingDiagonal(points);
}

/** A rig whose points have the faces given, and weights of two joints that change along x. */
function rigOf(points: Rig['points'], triangles: Rig['triangles']): Rig {
  const rig = rotatedTree();
  const rows = points.map(([x]) => [[0, 1 - x!] as const, [5, x!] as const]);
  return { ...rig, points, triangles, rows };
}

describe('delta mush', () => {
  const rig = rotatedTree();
  const character = characterOfRig(rig);
  const values = randomValues(rig, 5, 0.8);
  const q = qOfValues(character.skeleton, values);

  it.each([
    [0, 0.5],
    [3, 0],
    [3, 1],
    [8, 0.25],
    [30, 0.5],
  ])('agrees with the oracle for %s steps of λ = %s', (steps, lambda) => {
    const skinned = skinRigByOracle(rig, linearBlend, values).positions;
    const expected = deltaMushed(
      {
        triangles: rig.triangles,
        rest: rig.points,
        restNormals: rig.points.map((_, i) => numbersAt(character.mesh.normals, i, 3)),
        skinned: rig.points.map((_, i) => numbersAt(skinned, i, 3)),
      },
      steps,
      lambda,
    );
    const { positions, normals } = posed(character, q, { settings: { steps, lambda } });
    const bound = tolerances.skinning * boundingDiagonal(rig.points);
    expect(largestDifference(positions, expected.positions.flat())).toBeLessThan(bound);
    expect(largestDifference(normals, expected.normals.flat())).toBeLessThan(tolerances.normals);
  });

  it('is linear blend without smoothing', () => {
    const plain = posed(character, q, { method: linearBlend });
    for (const settings of [{ steps: 0 }, { lambda: 0 }]) {
      const difference = largestDifference(
        posed(character, q, { settings }).positions,
        plain.positions,
      );
      expect(difference).toBeLessThan(tolerances.skinning);
    }
  });

  it('smooths the steps of rigid weights', () => {
    const stepped = characterOfRig(unitWeights());
    const length = (streams: VertexStreams): number => longestEdge(stepped.mesh, streams.positions);
    const mushed = length(posed(stepped, q));
    expect(mushed).toBeLessThan(0.8 * length(posed(stepped, q, { method: linearBlend })));
  });

  it.each(['human', 'tube', 'hand', 'dog', 'panda'])(
    'at rest gives the %s as it is, also with most steps',
    async (id) => {
      const bundled = await readBundled(id);
      for (const steps of [15, 50]) {
        const { positions, normals } = posed(bundled, bundled.skeleton.qRest, {
          settings: { steps },
        });
        const bound = 1e-6 * sizeOf(bundled);
        expect(largestDifference(positions, bundled.mesh.positions)).toBeLessThan(bound);
        expect(largestDifference(normals, bundled.mesh.normals)).toBeLessThan(1e-4);
      }
    },
  );

  it.each(['by texture coordinates', 'by points'] as const)(
    'leaves no crack in a seam that is split %s',
    async (split) => {
      const [whole, parted] = await Promise.all([bentTube('none'), bentTube(split)]);
      const closed = posed(whole, bent(whole)).positions;
      const { positions } = posed(parted, bent(parted));
      const places = new Map<string, number[]>();
      for (let i = 0; i < whole.mesh.vertexCount; i++) {
        places.set(numbersAt(whole.mesh.positions, i, 3).join(), numbersAt(closed, i, 3));
      }
      for (let i = 0; i < parted.mesh.vertexCount; i++) {
        const expected = places.get(numbersAt(parted.mesh.positions, i, 3).join())!;
        expect(largestDifference(numbersAt(positions, i, 3), expected)).toBeLessThan(1e-6);
      }
    },
  );

  it('carries a correction at rest whole, without smoothing it', () => {
    const positions = character.mesh.positions.slice();
    positions[30] = positions[30]! + 0.5;
    const rest = { ...character.mesh, positions };
    const [plain, corrected] = [posed(character, q), posed(character, q, { rest })];
    const moved = [0, 1, 2].map((k) => corrected.positions[30 + k]! - plain.positions[30 + k]!);
    expect(Math.hypot(...moved)).toBeCloseTo(0.5, 5);
    corrected.positions.copyWithin(30, 27, 30);
    plain.positions.copyWithin(30, 27, 30);
    expect(corrected.positions).toEqual(plain.positions);
  });

  it('agrees with the oracle on an open sheet, whose boundary is smoothed along itself', () => {
    const across = [0, 1, 2, 3, 4];
    const points = across.flatMap((y) => across.map((x) => [x / 4, y / 4, 0]));
    const triangles = [0, 1, 2, 3].flatMap((y) =>
      [0, 1, 2, 3].flatMap((x) => {
        const a = y * 5 + x;
        return [
          [a, a + 1, a + 6],
          [a, a + 6, a + 5],
        ];
      }),
    );
    const sheet = rigOf(points, triangles);
    const expected = skinRigByOracle(sheet, deltaMush, values).positions;
    const sheetCharacter = characterOfRig(sheet);
    const difference = largestDifference(posed(sheetCharacter, q).positions, expected);
    expect(difference).toBeLessThan(tolerances.skinning);
  });

  it('never gives NaN, and leaves points without a surface where linear blend puts them', () => {
    const coordinate = fc.constantFrom(0, 0.25, 0.5, 1);
    const corner = fc.nat({ max: 7 });
    fc.assert(
      fc.property(
        fc.array(fc.tuple(coordinate, coordinate, coordinate), { minLength: 8, maxLength: 8 }),
        fc.array(fc.tuple(corner, corner, corner), { minLength: 1, maxLength: 12 }),
        fc.constantFrom(0, 1, 15, 50),
        fc.constantFrom(0, 0.5, 1),
        (points, triangles, steps, lambda) => {
          const odd = characterOfRig(rigOf(points, triangles));
          const { positions, normals } = posed(odd, q, { settings: { steps, lambda } });
          const plain = posed(odd, q, { method: linearBlend }).positions;
          expect(positions.every(Number.isFinite) && normals.every(Number.isFinite)).toBe(true);
          const used = new Set(triangles.flat().flatMap((index) => points[index]!.join()));
          points.forEach((place, i) => {
            if (used.has(place.join())) return;
            const both = [numbersAt(positions, i, 3), numbersAt(plain, i, 3)] as const;
            expect(largestDifference(...both)).toBeLessThan(tolerances.skinning);
          });
          const rest = posed(odd, odd.skeleton.qRest, { settings: { steps, lambda } }).positions;
          expect(largestDifference(rest, odd.mesh.positions)).toBeLessThan(1e-5);
        },
      ),
      { numRuns: 150 },
    );
  });
});

function longestEdge({ indices }: Mesh, positions: Float32Array): number {
  let longest = 0;
  for (let i = 0; i < indices.length; i++) {
    const next = i % 3 === 2 ? i - 2 : i + 1;
    const [a, b] = [indices[i]!, indices[next]!].map((vertex) => numbersAt(positions, vertex, 3));
    longest = Math.max(longest, Math.hypot(...a!.map((value, axis) => value - b![axis]!)));
  }
  return longest;
}
