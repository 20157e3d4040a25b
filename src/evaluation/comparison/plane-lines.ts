import type { CuttingPlane } from '../../document/cutting.ts';
import type { Mesh } from '../../core/mesh.ts';
import type { Skin } from '../../core/skin.ts';
import type { Vector3 } from '../../posing/ik/problem.ts';
import { heaviestEntry } from '../../skinning/heaviest-entry.ts';
import { weldedCorners } from './closed-components.ts';
import { type CutLine, cutLines } from './cut-lines.ts';
import { cornerOf } from './outline.ts';

/** A line of a cut, in its plane. */
export interface PlaneLine {
  /** (n × 2) to the right and up from the plane's origin, in model units. */
  readonly places: Float64Array;
  readonly isClosed: boolean;
}

/** Returns the triangles of a mesh with vertices that stand for all at their place at rest. */
export function cornersOf(mesh: Mesh): Uint32Array {
  let corners = known.get(mesh);
  if (!corners) known.set(mesh, (corners = weldedCorners(mesh.positions, mesh.indices)));
  return corners;
}

const known = new WeakMap<Mesh, Uint32Array>();

/**
 * Returns the triangles that have all corners on one part: those whose points follow the same joint
 * most. The others stretch between parts where rigid ones come apart.
 */
export function cornersOfParts(mesh: Mesh, skin: Skin): Uint32Array {
  let corners = parts.get(skin);
  if (corners) return corners;
  const all = cornersOf(mesh);
  const jointAt = (corner: number): number =>
    skin.paletteJoint[heaviestEntry(skin, mesh.pointOf[all[corner]!]!)]!;
  corners = all.filter((_, corner) => {
    const first = corner - (corner % 3);
    const joint = jointAt(first);
    return joint === jointAt(first + 1) && joint === jointAt(first + 2);
  });
  parts.set(skin, corners);
  return corners;
}

const parts = new WeakMap<Skin, Uint32Array>();

/** Cuts triangles by a plane and returns the lines as they lie in it. */
export function planeLines(
  positions: Float32Array,
  corners: Uint32Array,
  plane: CuttingPlane,
): PlaneLine[] {
  return cutLines(positions, corners, plane.origin, plane.normal)
    .map((line) => inPlane(line, positions, plane))
    .filter(({ places }) => places.length > 2);
}

/** Corners at one place, where a plane goes through a vertex, become one. */
function inPlane(line: CutLine, positions: Float32Array, plane: CuttingPlane): PlaneLine {
  const { origin, across, up } = plane;
  const places = new Float64Array(line.from.length * 2);
  let count = 0;
  for (let i = 0; i < line.from.length; i++) {
    const [x, y, z] = cornerOf(line, i, positions);
    const [dx, dy, dz] = [x - origin[0], y - origin[1], z - origin[2]];
    const right = dx * across[0] + dy * across[1] + dz * across[2];
    const rise = dx * up[0] + dy * up[1] + dz * up[2];
    if (count > 0 && places[count - 2] === right && places[count - 1] === rise) continue;
    places[count++] = right;
    places[count++] = rise;
  }
  return { places: places.subarray(0, count), isClosed: line.isClosed };
}

/** A place of the plane in the character's space. */
export function pointOf(
  { origin, across, up }: CuttingPlane,
  right: number,
  rise: number,
): Vector3 {
  const along = (axis: 0 | 1 | 2): number => origin[axis] + right * across[axis] + rise * up[axis];
  return [along(0), along(1), along(2)];
}
