import { normalsOf, rounded, type Shape, insectSurface } from './surface.ts';

/** Vertices that move less than this are left out, in model units. */
const smallest = 1e-4;

/**
 * Returns the `.morph` text of a shape: the positions and normals of the vertices that it moves.
 */
export function morphText(shape: Shape): string {
  const rest = insectSurface({ breath: 0, alert: 0 });
  const target = insectSurface(shape);
  const normals = normalsOf(target);
  const moved = rest.positions.flatMap((point, vertex) => {
    const other = target.positions[vertex]!;
    const distance = Math.hypot(other[0] - point[0], other[1] - point[1], other[2] - point[2]);
    return distance > smallest ? [vertex] : [];
  });
  const section = (name: string, row: (vertex: number) => readonly number[]): string => {
    const rows = moved.map((vertex) => `\t${vertex} ${row(vertex).join(' ')}\n`);
    return `${name} ${moved.length} {\n${rows.join('')}}\n`;
  };
  return (
    section('positions', (vertex) => rounded(target.positions[vertex]!, 4)) +
    section('normals', (vertex) => normals.slice(vertex * 3, vertex * 3 + 3))
  );
}
