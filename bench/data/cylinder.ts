import { randomSource } from '../../tests/support/random.ts';

/**
 * A bendable body of any size, the same in every run: a closed surface around a straight chain of
 * joints. It stands on the floor and is one unit tall, so that no program needs to scale it.
 */
export interface Cylinder {
  readonly vertexCount: number;
  readonly jointCount: number;
  /** (vertexCount × 3) at rest. */
  readonly positions: Float32Array;
  /** (2 × vertexCount triangles × 3, nearly) counterclockwise seen from outside. */
  readonly indices: Uint32Array;
  /** The distance from each joint to the next, along +y; the first joint is at the origin. */
  readonly jointSpacing: number;
  /** (vertexCount + 1) where each vertex's influences start. */
  readonly start: Uint32Array;
  readonly joints: Uint16Array;
  readonly weights: Float32Array;
}

export interface CylinderOptions {
  readonly vertexCount: number;
  readonly jointCount?: number;
  /** Four influences for each vertex, or one to five, three on average. */
  readonly influences?: 'four' | 'varied';
}

const usualJointCount = 18;
const radius = 0.12;

/**
 * Makes the body. The first joint has no weights, because a `.attach` file has no column for it.
 */
export function cylinder({
  vertexCount,
  jointCount = usualJointCount,
  influences = 'four',
}: CylinderOptions): Cylinder {
  const columns = columnsFor(vertexCount);
  const rings = vertexCount / columns;
  const positions = new Float32Array(vertexCount * 3);
  for (let ring = 0; ring < rings; ring++) {
    const height = ring / (rings - 1);
    const width = radius * (1 + 0.25 * Math.sin(9 * height));
    for (let column = 0; column < columns; column++) {
      const around = (column / columns) * 2 * Math.PI;
      const place = [width * Math.sin(around), height, width * Math.cos(around)];
      positions.set(place, (ring * columns + column) * 3);
    }
  }
  return {
    vertexCount,
    jointCount,
    positions,
    indices: trianglesOf(rings, columns),
    jointSpacing: 1 / (jointCount - 1),
    ...influencesOf(positions, jointCount, influences),
  };
}

/** The divisor of the count that makes triangles of about equal sides. */
function columnsFor(vertexCount: number): number {
  const wished = Math.sqrt(vertexCount) * 0.86;
  for (let columns = Math.round(wished); columns > 2; columns--) {
    if (vertexCount % columns === 0) return columns;
  }
  throw new Error(`${vertexCount} vertices do not fill whole rings`);
}

function trianglesOf(rings: number, columns: number): Uint32Array {
  const indices: number[] = [];
  for (let ring = 0; ring + 1 < rings; ring++) {
    for (let column = 0; column < columns; column++) {
      const next = (column + 1) % columns;
      const [a, b] = [ring * columns + column, ring * columns + next];
      const [c, d] = [a + columns, b + columns];
      indices.push(a, b, d, a, d, c);
    }
  }
  for (let column = 1; column + 1 < columns; column++) {
    const top = (rings - 1) * columns;
    indices.push(0, column + 1, column, top, top + column, top + column + 1);
  }
  return Uint32Array.from(indices);
}

/** Weights fall off with the distance along the chain; each row sums to one. */
function influencesOf(
  positions: Float32Array,
  jointCount: number,
  influences: 'four' | 'varied',
): Pick<Cylinder, 'start' | 'joints' | 'weights'> {
  const random = randomSource(1);
  const vertexCount = positions.length / 3;
  const start = new Uint32Array(vertexCount + 1);
  const joints: number[] = [];
  const weights: number[] = [];
  for (let vertex = 0; vertex < vertexCount; vertex++) {
    const wanted = influences === 'four' ? 4 : 1 + Math.floor(random() * 5);
    const count = Math.min(wanted, jointCount - 1);
    const along = positions[vertex * 3 + 1]! * (jointCount - 1);
    const first = Math.min(Math.max(1, Math.round(along - count / 2 + 0.5)), jointCount - count);
    const row = Array.from({ length: count }, (_, i) => 1 / (0.2 + Math.abs(first + i - along)));
    const sum = row.reduce((total, weight) => total + weight, 0);
    row.forEach((weight, i) => {
      joints.push(first + i);
      weights.push(weight / sum);
    });
    start[vertex + 1] = joints.length;
  }
  return { start, joints: Uint16Array.from(joints), weights: Float32Array.from(weights) };
}

/**
 * The angles of a pose, about X, Y and Z of each joint (`R = Rx · Ry · Rz`), in radians. Every
 * number of a pose gives another one; the body sways.
 *
 * @returns (jointCount × 3)
 */
export function poseAngles(jointCount: number, pose: number): Float64Array {
  const size = 1.1 / jointCount;
  return Float64Array.from(
    { length: jointCount * 3 },
    (_, i) => size * Math.sin(0.7 * pose + 0.2 * Math.floor(i / 3) + 2.1 * (i % 3)),
  );
}
