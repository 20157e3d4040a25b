/** Triangles around the origin, with a normal at each vertex. */
export interface SolidShape {
  /** (vertexCount × 3) */
  readonly positions: Float32Array;
  /** (vertexCount × 3) */
  readonly normals: Float32Array;
  /** (triangleCount × 3) */
  readonly indices: Uint16Array;
}

/**
 * Returns a line along +y from 0 to 1 for the line shader, which needs the line's other end as each
 * vertex's normal.
 */
export function segment(): SolidShape {
  return lines([
    [
      [0, 0, 0],
      [0, 1, 0],
    ],
  ]);
}

/**
 * Returns the handout's n × n grid of lines, with x and y from 0 to 1. The line shader wraps it to
 * a cylinder.
 */
export function lineGrid(n: number): SolidShape {
  const ends: Line[] = [];
  for (let row = 0; row <= n; row++) {
    for (let column = 0; column <= n; column++) {
      const here: Place = [column / n, row / n, 0];
      if (column > 0) ends.push([[(column - 1) / n, row / n, 0], here]);
      if (row > 0) ends.push([[column / n, (row - 1) / n, 0], here]);
    }
  }
  return lines(ends);
}

type Place = readonly [number, number, number];
type Line = readonly [Place, Place];

/** Creates two triangles per line. */
function lines(ends: readonly Line[]): SolidShape {
  const corners = [0, 1, 2, 0, 2, 3];
  return {
    positions: Float32Array.from(ends.flatMap(([a, b]) => [...a, ...a, ...b, ...b])),
    normals: Float32Array.from(ends.flatMap(([a, b]) => [...b, ...b, ...a, ...a])),
    indices: Uint16Array.from(ends.flatMap((_, line) => corners.map((i) => line * 4 + i))),
  };
}

/** Like the handout's drawSphere(…, 12, 12), returns a unit sphere of 12 slices and 12 stacks. */
export function sphere(slices = 12, stacks = 12): SolidShape {
  const positions: number[] = [];
  for (let stack = 0; stack <= stacks; stack++) {
    const polar = (Math.PI * stack) / stacks;
    for (let slice = 0; slice <= slices; slice++) {
      const around = (2 * Math.PI * slice) / slices;
      const level = Math.sin(polar);
      positions.push(level * Math.cos(around), Math.cos(polar), -level * Math.sin(around));
    }
  }
  const indices = gridTriangles(slices, stacks);
  const packed = Float32Array.from(positions);
  return { positions: packed, normals: packed, indices };
}

/**
 * Like the handout's drawCylinder(6, …), returns six sides of radius 1 along +y from 0 to 1, with
 * ends.
 */
export function cylinder(sides = 6): SolidShape {
  const positions: number[] = [];
  const normals: number[] = [];
  const ring = (y: number, normalOf: (x: number, z: number) => number[]): void => {
    for (let side = 0; side <= sides; side++) {
      const around = (2 * Math.PI * side) / sides;
      const [x, z] = [Math.cos(around), -Math.sin(around)];
      positions.push(x, y, z);
      normals.push(...normalOf(x, z));
    }
  };
  // The rings from the top are the upper lid, the upper and lower edge of the sides, and the lower
  // lid.
  ring(1, () => [0, 1, 0]);
  ring(1, (x, z) => [x, 0, z]);
  ring(0, (x, z) => [x, 0, z]);
  ring(0, () => [0, -1, 0]);
  const between = gridTriangles(sides, 3).slice(sides * 6, sides * 12);
  const lids: number[] = [];
  const bottom = 3 * (sides + 1);
  for (let side = 1; side + 1 < sides; side++) {
    lids.push(0, side, side + 1, bottom, bottom + side + 1, bottom + side);
  }
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    indices: Uint16Array.from([...between, ...lids]),
  };
}

/** Returns a cube from -1 to 1, in which each face has its own four vertices. */
export function cube(): SolidShape {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [-1, 1]) {
      const first = positions.length / 3;
      // The corners go around the face, counterclockwise seen from outside.
      for (const [u, v] of [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ] as const) {
        const corner = [side, side * u, v];
        positions.push(...[0, 1, 2].map((i) => corner[(i - axis + 3) % 3]!));
        normals.push(...[0, 1, 2].map((i) => (i === axis ? side : 0)));
      }
      indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
    }
  }
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    indices: Uint16Array.from(indices),
  };
}

/**
 * Returns the triangles between rings of `columns` + 1 vertices, with `rows` + 1 rings from top to
 * bottom.
 */
function gridTriangles(columns: number, rows: number): Uint16Array {
  const indices: number[] = [];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const a = row * (columns + 1) + column;
      const below = a + columns + 1;
      indices.push(a, below, below + 1, a, below + 1, a + 1);
    }
  }
  return Uint16Array.from(indices);
}
