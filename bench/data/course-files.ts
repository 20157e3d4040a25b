import { noBone, pmdFile, type PmdContent } from '../../tests/support/pmd-files.ts';
import { writeSkin } from '../../src/formats/cse169/write-skin.ts';
import { characterOf } from './character.ts';
import { type Cylinder, cylinder } from './cylinder.ts';

export type CourseFile = 'skel' | 'obj' | 'attach' | 'skin' | 'pmd';

/** The sizes at which readers are compared. */
export const courseSizes = { obj: 100_000, attach: 100_000, skin: 30_000, pmd: 12_000 } as const;

const encoder = new TextEncoder();

/** Writes a body in the form of a course's file. */
export const courseFiles: Readonly<Record<CourseFile, (body: Cylinder) => Uint8Array>> = {
  /** An offset and a parent a line. */
  skel: ({ jointCount, jointSpacing }) =>
    lines(
      Array.from(
        { length: jointCount },
        (_, joint) => `0 ${joint === 0 ? 0 : jointSpacing} 0 ${joint - 1}`,
      ),
    ),
  /** Positions and triangles, without normals, with six digits as in 6.837's models. */
  obj: ({ positions, indices }) =>
    lines([...rows('v', positions, digits), ...rows('f', indices, oneBased)]),
  /** A weight for each joint but the first, with four digits, and a space that ends the line. */
  attach: ({ vertexCount, jointCount, start, joints, weights }) =>
    lines(
      Array.from({ length: vertexCount }, (_, vertex) => {
        const row = new Array<number>(jointCount - 1).fill(0);
        for (let i = start[vertex]!; i < start[vertex + 1]!; i++) row[joints[i]! - 1] = weights[i]!;
        return `${row.map((weight) => Number(weight.toFixed(4))).join(' ')} `;
      }),
    ),
  skin: (body) => writeSkin(characterOf(body)),
  pmd: (body) => pmdFile(pmdContent(body)).bytes,
};

/** The body whose file is read. */
export function courseBody(kind: keyof typeof courseSizes): Cylinder {
  return cylinder({ vertexCount: courseSizes[kind] });
}

function lines(all: readonly string[]): Uint8Array {
  return encoder.encode(`${all.join('\n')}\n`);
}

function rows(
  keyword: string,
  values: ArrayLike<number>,
  write: (value: number) => string,
): string[] {
  return Array.from({ length: values.length / 3 }, (_, row) => {
    const [a, b, c] = [values[row * 3]!, values[row * 3 + 1]!, values[row * 3 + 2]!];
    return `${keyword} ${write(a)} ${write(b)} ${write(c)}`;
  });
}

function digits(value: number): string {
  return String(Number(value.toPrecision(6)));
}

function oneBased(index: number): string {
  return String(index + 1);
}

/** Two influences a vertex, because a PMD holds no more. */
function pmdContent(body: Cylinder): PmdContent {
  const { positions, indices, vertexCount, start, joints, weights, jointCount } = body;
  return {
    vertices: Array.from({ length: vertexCount }, (_, vertex) => {
      const [x, y, z] = positions.subarray(vertex * 3, vertex * 3 + 3) as unknown as number[];
      const first = start[vertex]!;
      const sum = weights[first]! + weights[first + 1]!;
      return {
        position: [x!, y!, z!],
        normal: [0, 0, -1],
        uv: [0.5, y!],
        bones: [joints[first]!, joints[first + 1]!],
        weight: Math.round((100 * weights[first]!) / sum),
      };
    }),
    indices: [...indices],
    materials: [{ count: indices.length }],
    bones: Array.from({ length: jointCount }, (_, joint) => ({
      name: `joint ${joint}`,
      parent: joint === 0 ? noBone : joint - 1,
      head: [0, joint * body.jointSpacing, 0],
    })),
  };
}
