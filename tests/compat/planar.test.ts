import { vec4 } from 'gl-matrix';
import { expect, it } from 'vitest';
import { type Plane, planarMirror, type PlanarLight, planarShadow } from '../../src/core/planar.ts';
import { tolerances } from '../tolerances.ts';
import { describeWithShared, sharedJson } from './shared-material.ts';

type Triple = readonly [number, number, number];

interface PlanarRow {
  readonly plane: Plane;
  readonly light: PlanarLight;
  readonly shadow_row_major: readonly number[];
  readonly mirror_row_major: readonly number[];
  readonly points: readonly Triple[];
  readonly shadow_points: readonly (Triple | null)[];
  readonly mirror_points: readonly Triple[];
}

const path = 'reference/planar.json';

describeWithShared('planar shadows and mirrors', [path], () => {
  const { rows } = sharedJson(path) as { readonly rows: readonly PlanarRow[] };

  it('have the matrices of the table', () => {
    expect(rows.length).toBeGreaterThan(1);
    for (const { plane, light, shadow_row_major, mirror_row_major } of rows) {
      expectRows(planarShadow(plane, light), shadow_row_major);
      expectRows(planarMirror(plane), mirror_row_major);
    }
  });

  it('move points to where the table says', () => {
    let compared = 0;
    for (const { plane, light, points, shadow_points, mirror_points } of rows) {
      points.forEach((point, index) => {
        const moved = [planarShadow(plane, light), planarMirror(plane)].map((matrix) => {
          const [x, y, z, w] = vec4.transformMat4(new Float64Array(4), [...point, 1], matrix);
          return [x! / w!, y! / w!, z! / w!];
        });
        [shadow_points[index], mirror_points[index]].forEach((expected, kind) => {
          expected?.forEach((value, axis) => {
            expect(Math.abs(moved[kind]![axis]! - value)).toBeLessThan(tolerances.planar);
            compared++;
          });
        });
      });
    }
    expect(compared).toBeGreaterThan(40);
  });
});

function expectRows(matrix: ArrayLike<number>, rowMajor: readonly number[]): void {
  rowMajor.forEach((value, i) => {
    const [row, column] = [i >> 2, i & 3];
    expect(Math.abs(matrix[column * 4 + row]! - value)).toBeLessThan(tolerances.planar);
  });
}
