import fc from 'fast-check';
import { quat, vec3 } from 'gl-matrix';
import { describe, expect, it } from 'vitest';
import { cutLines } from '../../../src/evaluation/comparison/cut-lines.ts';
import { cutOutlines, outlineArea } from '../../../src/evaluation/comparison/outline.ts';
import { cube, meshOf, type Solid, sphere } from '../../fixtures/solids.ts';

type Triple = [number, number, number];

const origin: Triple = [0, 0, 0];
const block = cube(2, [-1, -1, -1]);

function areas(solid: Solid, at: Triple, normal: Triple): number[] {
  const mesh = meshOf(solid);
  return cutOutlines(mesh, at, normal).map((outline) => outlineArea(outline, mesh.positions));
}

/** A closed surface around the y axis whose profile is a regular polygon around (radius, 0). */
function torus(radius: number, thickness: number, sides: number): Solid {
  const points = Array.from({ length: sides * sides }, (_, i) => {
    const [around, along] = [Math.floor(i / sides), i % sides];
    const [a, b] = [around, along].map((each) => (2 * Math.PI * (each + 0.25)) / sides);
    const reach = radius + thickness * Math.cos(b!);
    return [reach * Math.cos(a!), thickness * Math.sin(b!), reach * Math.sin(a!)];
  });
  return { points, triangles: grid(sides, sides, true) };
}

/** The triangles of rows of quadrangles; rows are closed, and columns where the last says so. */
function grid(rows: number, sides: number, isClosed: boolean): number[][] {
  const at = (row: number, side: number) => (row % rows) * sides + (side % sides);
  return Array.from({ length: isClosed ? rows : rows - 1 }, (_, row) =>
    Array.from({ length: sides }, (_, side) => [
      [at(row, side), at(row, side + 1), at(row + 1, side)],
      [at(row + 1, side), at(row, side + 1), at(row + 1, side + 1)],
    ]),
  ).flat(2);
}

/** A tube of radius 1 along y from 0 to 3, open at both ends. */
function openTube(sides: number): Solid {
  const points = Array.from({ length: 4 * sides }, (_, i) => {
    const angle = (2 * Math.PI * (i % sides)) / sides;
    return [Math.cos(angle), Math.floor(i / sides), Math.sin(angle)];
  });
  return { points, triangles: grid(4, sides, false) };
}

describe('the cut of a surface', () => {
  it('is one square of a cube, also through its vertices, edges and faces', () => {
    expect(areas(block, [0, 0.3, 0], [0, 1, 0])).toEqual([4]);
    // Vertices on the plane count as above it: so the upper face is cut, from within, and the lower not.
    expect(areas(block, [0, -1, 0], [0, 1, 0])).toEqual([]);
    expect(areas(block, [0, 1, 0], [0, 1, 0])).toEqual([4]);
    const [diagonal] = areas(block, origin, [1, 0, -1]);
    expect(diagonal).toBeCloseTo(4 * Math.SQRT2, 6);
    const [hexagon] = areas(block, origin, [1, 1, 1]);
    expect(hexagon).toBeCloseTo(3 * Math.sqrt(3), 6);
  });

  it('is a circle of a sphere at each height', () => {
    for (const height of [-0.9, -0.5, 0, 0.25, 0.7]) {
      const [area, ...others] = areas(sphere(96, 192), [0, height, 0], [0, 2, 0]);
      expect(others).toEqual([]);
      expect(area! / (Math.PI * (1 - height ** 2))).toBeCloseTo(1, 2);
    }
  });

  it('is two loops of a torus through its axis, and two nested ones across it', () => {
    const sides = 48;
    const polygon = (radius: number) => (sides / 2) * radius ** 2 * Math.sin((2 * Math.PI) / sides);
    const through = areas(torus(2, 0.5, sides), origin, [0, 0, 1]);
    expect(through).toHaveLength(2);
    for (const area of through) expect(area).toBeCloseTo(polygon(0.5), 1);
    const across = areas(torus(2, 0.5, sides), origin, [0, 1, 0]).sort((a, b) => a - b);
    expect(across[0]).toBeCloseTo(polygon(1.5), 1);
    expect(across[1]).toBeCloseTo(polygon(2.5), 1);
  });

  it('is a closed ring and open lines of an open tube, each in one piece', () => {
    const { positions, indices } = meshOf(openTube(12));
    const rings = cutLines(positions, indices, [0, 1.5, 0], [0, 1, 0]);
    expect(rings.map(({ isClosed, from }) => [isClosed, from.length])).toEqual([[true, 24]]);
    const sidesOf = cutLines(positions, indices, [0.1, 0, 0], [1, 0, 0]);
    expect(sidesOf.map(({ isClosed }) => isClosed)).toEqual([false, false]);
    // The planes through the vertices of two sides as well.
    const exact = cutLines(positions, indices, origin, [0, 0, 1]);
    expect(exact.map(({ isClosed }) => isClosed)).toEqual([false, false]);
    expect(cutOutlines(meshOf(openTube(12)), origin, [0, 0, 1])).toEqual([]);
  });

  it('holds together where triangles face different ways', () => {
    const { points, triangles } = block;
    const mixed = triangles.map((corners, i) => (i % 3 === 0 ? [...corners].reverse() : corners));
    const { positions, indices } = meshOf({ points, triangles: mixed });
    const lines = cutLines(positions, indices, [0, 0.3, 0], [0, 1, 0]);
    expect(lines.map(({ isClosed }) => isClosed)).toEqual([true]);
    expect(outlineArea(lines[0]!, positions)).toBeCloseTo(4, 6);
  });

  it('is none where the plane passes by, or there is no surface', () => {
    expect(areas(sphere(), [0, 3, 0], [0, 1, 0])).toEqual([]);
    expect(cutLines(new Float32Array(0), new Uint32Array(0), origin, [0, 1, 0])).toEqual([]);
  });

  it('has the same area when surface and plane turn and move together', () => {
    const number = fc.double({ min: -1, max: 1, noNaN: true });
    const four = fc.tuple(number, number, number, number);
    const turns = four.filter((q) => Math.hypot(...q) > 0.1);
    const mesh = meshOf(sphere(16, 24));
    const [before] = areas(sphere(16, 24), [0, 0.3, 0], [0, 1, 0]);
    fc.assert(
      fc.property(turns, fc.tuple(number, number, number), (turn, move) => {
        const rotation = quat.normalize([0, 0, 0, 1], turn);
        const moved = (point: Triple): Triple => {
          const to: Triple = [0, 0, 0];
          vec3.add(to, vec3.transformQuat(to, point, rotation), move);
          return to;
        };
        const normal: Triple = [0, 0, 0];
        vec3.transformQuat(normal, [0, 1, 0], rotation);
        const positions = new Float32Array(mesh.positions.length);
        for (let at = 0; at < positions.length; at += 3) {
          const [x, y, z] = mesh.positions.subarray(at, at + 3);
          positions.set(moved([x!, y!, z!]), at);
        }
        const outlines = cutOutlines({ ...mesh, positions }, moved([0, 0.3, 0]), normal);
        expect(outlines).toHaveLength(1);
        expect(outlineArea(outlines[0]!, positions)).toBeCloseTo(before!, 5);
      }),
      { numRuns: 50 },
    );
  });
});
