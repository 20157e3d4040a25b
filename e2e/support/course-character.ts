import { courseSkel } from '../../tests/support/course-skeleton.ts';
import type { NamedFile } from './app.ts';

/**
 * Makes a character with the course's 18 joints: a cube around each joint but the root, which has
 * no column in the `.attach`.
 *
 * @param cuts the number of squares along an edge of a cube, by which the files grow
 */
export function courseCharacter(cuts = 1): NamedFile[] {
  const joints = courseSkel
    .trimEnd()
    .split('\n')
    .map((line) => line.split(' ').map(Number) as [number, number, number, number]);
  const places: number[][] = [];
  for (const [x, y, z, parent] of joints) {
    places.push([x, y, z].map((offset, axis) => offset + (places[parent]?.[axis] ?? 0)));
  }
  const obj: string[] = [];
  const attach: string[] = [];
  const side = cuts + 1;
  for (const [joint, place] of places.entries()) {
    if (joint === 0) continue;
    const row = joints.slice(1).map((_, column) => Number(column + 1 === joint));
    for (let face = 0; face < 6; face++) {
      const first = attach.length + 1;
      const axis = face % 3;
      for (let v = 0; v < side; v++) {
        for (let u = 0; u < side; u++) {
          const offset = [0, 0, 0];
          offset[axis] = face < 3 ? 1 : -1;
          offset[(axis + 1) % 3] = (2 * u) / cuts - 1;
          offset[(axis + 2) % 3] = ((2 * v) / cuts - 1) * (face < 3 ? 1 : -1);
          obj.push(`v ${place.map((at, i) => (at + 0.3 * offset[i]!).toFixed(5)).join(' ')}`);
          attach.push(row.join(' '));
        }
      }
      for (let v = 0; v < cuts; v++) {
        for (let u = 0; u < cuts; u++) {
          const [a, b] = [first + v * side + u, first + (v + 1) * side + u];
          obj.push(`f ${a} ${a + 1} ${b + 1}`, `f ${a} ${b + 1} ${b}`);
        }
      }
    }
  }
  const files = { skel: courseSkel, obj: obj.join('\n'), attach: attach.join('\n') };
  return Object.entries(files).map(([kind, content]) => ({ name: `course.${kind}`, content }));
}
