import { readFileSync } from 'node:fs';
import path from 'node:path';
import { gunzipSync, gzipSync } from 'node:zlib';

/** Files of the bundled characters in base64, by the ends of their addresses. */
export type SmallFiles = Readonly<Record<string, string>>;

type Lines = readonly string[];
type Point = readonly number[];

const data = path.resolve(import.meta.dirname, '../../public/data');
/** Characters, and the side of a cube that is one vertex of theirs, as a part of their height. */
const withObj = { human: 0.025, dog: 0.04, tube: 0.05 } as const;
const withSkin = { insect: 0.09 } as const;

/**
 * Bundled characters with the same joints and about a tenth of the triangles, which take most of
 * the time of small pictures. Each vertex stands for those in a cube around it, and has its own
 * weights.
 */
export function smallCharacters(): SmallFiles {
  const files: Record<string, string> = {};
  const add = (name: string, kind: string, content: Lines): void => {
    const packed = gzipSync(`${content.join('\n')}\n`);
    files[`/${name}/${name}.${kind}.gz`] = packed.toString('base64');
  };
  for (const [name, cell] of Object.entries(withObj)) {
    const { obj, kept } = smallObj(linesOf(name, 'obj'), cell);
    const weights = linesOf(name, 'attach');
    add(name, 'obj', obj);
    add(
      name,
      'attach',
      kept.map((vertex) => weights[vertex]!),
    );
  }
  for (const [name, cell] of Object.entries(withSkin)) {
    add(name, 'skin', smallSkin(linesOf(name, 'skin'), cell));
  }
  return files;
}

function linesOf(name: string, kind: string): Lines {
  const bytes = gunzipSync(readFileSync(path.join(data, name, `${name}.${kind}.gz`)));
  return bytes.toString().trimEnd().split('\n');
}

/** Returns for each point the first one in its cube. */
function firstInCube(points: readonly Point[], cell: number): readonly number[] {
  const heights = points.map((point) => point[1]!);
  const side = cell * (Math.max(...heights) - Math.min(...heights));
  const found = new Map<string, number>();
  return points.map((point, index) => {
    const cube = point.map((coordinate) => Math.round(coordinate / side)).join();
    if (!found.has(cube)) found.set(cube, index);
    return found.get(cube)!;
  });
}

const numbers = (words: string): readonly number[] => words.trim().split(/\s+/).map(Number);

/** Returns the lines of a smaller OBJ, and which vertices of the first one it has. */
function smallObj(lines: Lines, cell: number): { obj: Lines; kept: readonly number[] } {
  const points = lines
    .filter((line) => line.startsWith('v '))
    .map((line) => numbers(line.slice(2)));
  const firsts = firstInCube(points, cell);
  const kept = [...new Set(firsts)];
  const newNumbers = new Map(kept.map((vertex, index) => [vertex, index + 1]));
  const obj: string[] = kept.map((vertex) => `v ${points[vertex]!.join(' ')}`);
  const coordinates: string[] = [];
  /** The number of each vertex's texture coordinates, the first that a face gives it. */
  const covered = new Map<number, number>();
  let read = 0;
  /** Counts from the first one, or backwards from the last one that was read. */
  const at = (number: number, count: number): number => (number > 0 ? number - 1 : count + number);
  for (const line of lines) {
    if (line.startsWith('v ')) read++;
    else if (line.startsWith('vt ')) coordinates.push(line);
    else if (line.startsWith('f ')) {
      const corners = line
        .split(' ')
        .slice(1)
        .map((corner) => {
          const [v, vt] = corner.split('/').map(Number) as [number, number];
          const vertex = newNumbers.get(firsts[at(v, read)]!)!;
          if (!covered.has(vertex)) {
            covered.set(vertex, covered.size + 1);
            obj.push(coordinates[at(vt, coordinates.length)]!);
          }
          return `${vertex}/${covered.get(vertex)}`;
        });
      const face = [...new Set(corners)];
      if (face.length > 2) obj.push(`f ${face.join(' ')}`);
    } else obj.push(line);
  }
  return { obj, kept };
}

/** Returns the lines of a `.skin` with all of its vertices, of which fewer are in triangles. */
function smallSkin(lines: Lines, cell: number): Lines {
  const begin = (block: string): number => lines.findIndex((line) => line.startsWith(`${block} `));
  const rows = (block: string): Lines => {
    const first = begin(block);
    return lines.slice(first + 1, first + 1 + Number(lines[first]!.split(' ')[1]));
  };
  const firsts = firstInCube(rows('positions').map(numbers), cell);
  const triangles = rows('triangles');
  const kept = triangles
    .map((row) => numbers(row).map((vertex) => firsts[vertex]!))
    .filter((corners) => new Set(corners).size === 3)
    .map((corners) => corners.join(' '));
  const first = begin('triangles');
  return [
    ...lines.slice(0, first),
    `triangles ${kept.length} {`,
    ...kept,
    ...lines.slice(first + 1 + triangles.length),
  ];
}
