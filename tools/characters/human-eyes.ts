import type { CutMesh } from './cut-faces.ts';
import type { Face } from './pack-mesh.ts';
import { meanOf, subtract, type Vector3 } from './vector.ts';

/**
 * The eyeballs. Those of the base mesh are too coarse for an iris, so spheres of the same places
 * and sizes take their place, with rings of faces around the axis along which they look.
 */

const SEGMENTS = 24;

/** The angles of the rings of vertices to the axis, in degrees, with what lies before each. */
const RINGS: readonly (readonly [angle: number, material: EyeMaterial])[] = [
  [10, 'pupils'],
  [17, 'irises'],
  [23.5, 'irises'],
  [26.5, 'iris rims'],
  [36, 'eyes'],
  [48, 'eyes'],
  [62, 'eyes'],
  [78, 'eyes'],
  [100, 'eyes'],
  [135, 'eyes'],
];

export type EyeMaterial = 'eyes' | 'iris rims' | 'irises' | 'pupils';

/**
 * Adds the spheres to the mesh and returns their faces by material.
 *
 * @param leftEye the vertices of the base mesh's left eyeball, which the right one mirrors
 */
export function addEyes(
  mesh: CutMesh,
  leftEye: readonly number[],
): ReadonlyMap<EyeMaterial, readonly Face[]> {
  const points = leftEye.map((vertex) => mesh.positions[vertex]!);
  const center = meanOf(points);
  const radius = meanOf(points.map((point) => [Math.hypot(...subtract(point, center)), 0, 0]))[0];
  const row = mesh.weights[leftEye[0]!]!;
  const texture = mesh.textureCoordinates.push([0, 0]) - 1;
  const start = mesh.positions.length;

  // Each vertex of the left eye is followed by its mirror image.
  const add = (angle: number, around: number): void => {
    const across = radius * Math.sin(angle);
    const [x, y, z]: Vector3 = [
      center[0] + across * Math.cos(around),
      center[1] + across * Math.sin(around),
      center[2] + radius * Math.cos(angle),
    ];
    const vertex = mesh.positions.push([x, y, z], [-x, y, z]) - 2;
    mesh.unshaped.push([x, y, z], [-x, y, z]);
    mesh.mirror.push(vertex + 1, vertex);
    mesh.weights.push(row, row);
  };
  add(0, 0);
  for (const [degrees] of RINGS) {
    for (let segment = 0; segment < SEGMENTS; segment++) {
      add((degrees * Math.PI) / 180, (segment / SEGMENTS) * 2 * Math.PI);
    }
  }
  add(Math.PI, 0);

  const vertexAt = (ring: number, segment: number): number =>
    ring < 0 ? 0 : ring === RINGS.length ? 1 + ring * SEGMENTS : 1 + ring * SEGMENTS + segment;
  const faces = new Map<EyeMaterial, Face[]>();
  for (let ring = 0; ring <= RINGS.length; ring++) {
    const material = RINGS[ring]?.[1] ?? 'eyes';
    const ofMaterial = faces.get(material) ?? [];
    faces.set(material, ofMaterial);
    for (let segment = 0; segment < SEGMENTS; segment++) {
      const next = (segment + 1) % SEGMENTS;
      const corners = new Set([
        ...[vertexAt(ring - 1, segment), vertexAt(ring, segment)],
        ...[vertexAt(ring, next), vertexAt(ring - 1, next)],
      ]);
      const left = [...corners];
      for (const [side, vertices] of [left, left.toReversed()].entries()) {
        ofMaterial.push(
          vertices.map((vertex) => ({ position: start + 2 * vertex + side, texture })),
        );
      }
    }
  }
  return faces;
}
