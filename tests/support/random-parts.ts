import fc from 'fast-check';
import type { CharacterParts, MeshParts, SkinParts } from '../../src/core/character-parts.ts';
import { DofKind } from '../../src/core/skeleton.ts';

/** Boundary sizes and values: numbers that GPUs flush, their neighbors, and ordinary ones. */
const coordinate = fc.oneof(
  fc.float({ noNaN: true, min: Math.fround(-1e6), max: Math.fround(1e6) }),
  fc.constantFrom(0, -0, 1e-45, -1e-40, 1.17e-38, 1.2e-38, -1.3e-38, 1e-30, 1e18),
);

const material = fc.oneof(
  fc.constantFrom('', 'a', 'b c', '#', '__proto__', 'constructor', '<img onerror=x>', '\u202egnp'),
  fc
    .string({ unit: 'grapheme', maxLength: 5 })
    .filter((name) => /^\S+$/.test(name) && !name.endsWith('\\')),
);

/**
 * A mesh as a reader may return it: any triangles, with or without texture coordinates and normals.
 */
export const meshParts: fc.Arbitrary<MeshParts> = fc
  .record({
    points: tuples(coordinate, 3, 3, 10),
    uvs: tuples(coordinate, 2, 1, 6),
    normals: tuples(coordinate, 3, 1, 6),
    withUvs: fc.boolean(),
    withNormals: fc.boolean(),
    faces: fc.array(
      fc.record({ material, choices: fc.array(fc.nat(), { minLength: 9, maxLength: 9 }) }),
      {
        minLength: 1,
        maxLength: 12,
      },
    ),
  })
  .map(({ points, uvs, normals, withUvs, withNormals, faces }) => {
    const corners = faces.flatMap(({ choices }) =>
      [0, 1, 2].map((k) => ({
        // Three consecutive points, so that none occurs twice.
        point: (choices[0]! + k) % points.length,
        uv: (choices[3 + k]! % (uvs.length + 1)) - 1,
        normal: (choices[6 + k]! % (normals.length + 1)) - 1,
      })),
    );
    return {
      file: 'a.obj',
      positions: Float32Array.from(points.flat()),
      cornerPoints: Uint32Array.from(corners, ({ point }) => point),
      ...(withUvs
        ? {
            uvs: Float32Array.from(uvs.flat()),
            cornerUvs: Int32Array.from(corners, ({ uv }) => uv),
          }
        : {}),
      ...(withNormals
        ? {
            normals: Float32Array.from(normals.flat()),
            cornerNormals: Int32Array.from(corners, ({ normal }) => normal),
          }
        : {}),
      submeshes: faces
        .map((face, firstTriangle) => ({ material: face.material, firstTriangle }))
        .filter((run, i, runs) => run.material !== runs[i - 1]?.material),
    };
  });

const weight = fc.oneof(
  fc.float({ noNaN: true, min: Math.fround(-1e6), max: Math.fround(1e6) }),
  fc.float({ noNaN: true, min: 0, max: 1 }),
  fc.constantFrom(1e-45, 9.9e-7, -9.9e-7, 1e-6, 1),
);

/** A mesh on a chain of joints; the first joint has no weights, as in `.attach`. */
export const skinnedParts: fc.Arbitrary<CharacterParts> = fc
  .tuple(meshParts, fc.integer({ min: 2, max: 12 }))
  .chain(([mesh, jointCount]) => {
    const influence = fc.tuple(fc.integer({ min: 1, max: jointCount - 1 }), weight);
    const row = fc.uniqueArray(influence, { selector: ([joint]) => joint, maxLength: jointCount });
    const pointCount = mesh.positions.length / 3;
    return fc
      .tuple(
        fc.array(row, { minLength: pointCount, maxLength: pointCount }),
        fc.array(fc.tuple(coordinate, coordinate, coordinate), {
          minLength: jointCount,
          maxLength: jointCount,
        }),
      )
      .map(([rows, offsets]) => partsOf(mesh, offsets, rows));
  });

function partsOf(
  mesh: MeshParts,
  offsets: readonly [number, number, number][],
  rows: readonly (readonly [number, number])[][],
): CharacterParts {
  const hinges = (
    [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ] as const
  ).map((axis) => ({ kind: DofKind.hinge, axis }));
  const slides = hinges.map(({ axis }) => ({ kind: DofKind.slide, axis }));
  const joints = offsets.map((restOffset, index) => ({
    name: `joint ${String(index).padStart(2, '0')}`,
    parent: index - 1,
    restOffset,
    dofs: index === 0 ? [...slides, ...hinges] : hinges,
  }));
  return {
    name: 'a',
    missing: [],
    skeleton: { file: 'a.skel', joints },
    mesh,
    skin: skinOf(rows.map((row) => row.toSorted(([a], [b]) => a - b))),
  };
}

function skinOf(rows: readonly (readonly (readonly [number, number])[])[]): SkinParts {
  const influences = rows.flat();
  const start = new Uint32Array(rows.length + 1);
  rows.forEach((row, point) => (start[point + 1] = start[point]! + row.length));
  return {
    file: 'a.attach',
    start,
    joints: Uint16Array.from(influences, ([joint]) => joint),
    weights: Float32Array.from(influences, ([, each]) => each),
  };
}

function tuples(
  value: fc.Arbitrary<number>,
  size: number,
  fewest: number,
  most: number,
): fc.Arbitrary<number[][]> {
  const tuple = fc.array(value, { minLength: size, maxLength: size });
  return fc.array(tuple, { minLength: fewest, maxLength: most });
}
