import { vec3 } from 'gl-matrix';
import { describe, expect, it } from 'vitest';
import { seenPart } from '../../../src/view/picture/seen-part.ts';

/** A grid of points in the plane at a height z, from -1 to 1, or larger and moved to the right. */
function sheet(z: number, right = 0, size = 1, side = 9) {
  const step = 2 / (side - 1);
  const points = Array.from({ length: side * side }, (_, i) => {
    const [x, y] = [(i % side) * step - 1, Math.floor(i / side) * step - 1];
    return [size * x + right, size * y, z];
  });
  const triangles = points.flatMap((_, i) => {
    if (i % side === side - 1 || i + side >= points.length) return [];
    return [
      [i, i + 1, i + side],
      [i + 1, i + side + 1, i + side],
    ];
  });
  return { points, triangles };
}

/** The sheets as one surface that faces +z, of which the first one counts. */
function surfaceOf(...sheets: ReturnType<typeof sheet>[]) {
  const points = sheets.flatMap((each) => each.points);
  const indices = sheets.flatMap(({ triangles }, i) =>
    triangles.flat().map((corner) => corner + i * sheets[0]!.points.length),
  );
  const surface = {
    positions: Float32Array.from(points.flat()),
    normals: Float32Array.from(points.flatMap(() => [0, 0, 1])),
    indices: Uint32Array.from(indices),
  };
  const weights = Float32Array.from(points, (_, i) => (i < sheets[0]!.points.length ? 1 : 0));
  return { surface, weights };
}

function seen(sheets: ReturnType<typeof sheet>[], direction: [number, number, number]): number {
  const { surface, weights } = surfaceOf(...sheets);
  const towards = vec3.normalize(new Float64Array(3), direction);
  const square = { middle: [0, 0, 0] as vec3, direction: towards, half: 1.5, distance: 5 };
  return seenPart(surface, weights, square);
}

describe('the part of a surface that is seen', () => {
  it('is all of a sheet that faces the eye, by its cosine, and nothing of one that is turned away', () => {
    expect(seen([sheet(0)], [0, 0, 1])).toBeCloseTo(1, 6);
    expect(seen([sheet(0)], [0, 1, 1])).toBeCloseTo(Math.SQRT1_2, 6);
    expect(seen([sheet(0)], [0, 0, -1])).toBe(0);
    expect(seen([sheet(0)], [0, 1, 0])).toBeCloseTo(0, 6);
  });

  it('is nothing of what is covered, but what covers must be between it and the eye', () => {
    expect(seen([sheet(0), sheet(1, 0, 1.2)], [0, 0, 1])).toBe(0);
    expect(seen([sheet(0), sheet(-1, 0, 1.2)], [0, 0, 1])).toBeCloseTo(1, 6);
    expect(seen([sheet(0), sheet(6, 0, 1.2)], [0, 0, 1])).toBeCloseTo(1, 6);
    const half = seen([sheet(0), sheet(1, 1.2, 1.2)], [0, 0, 1]);
    expect(half).toBeGreaterThan(0.4);
    expect(half).toBeLessThan(0.6);
    // Seen past the edge of what covers it.
    expect(seen([sheet(0), sheet(1, 1.2, 1.2)], [-2, 0, 1])).toBeGreaterThan(0.9 * Math.sqrt(0.2));
  });

  it('is nothing of what is outside of the square or does not count', () => {
    expect(seen([sheet(0, 3)], [0, 0, 1])).toBe(0);
    const { surface, weights } = surfaceOf(sheet(0));
    const square = {
      middle: [0, 0, 0] as vec3,
      direction: [0, 0, 1] as vec3,
      half: 1.5,
      distance: 5,
    };
    expect(seenPart(surface, weights.fill(0), square)).toBe(0);
  });
});
