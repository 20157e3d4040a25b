import type { Corner, Face, SourceMesh } from './pack-mesh.ts';
import type { Vector2, Vector3 } from './vector.ts';
import { writeCharacter } from './write-character.ts';

/** In meters. The tube stands on the origin along +y and is rounded at both ends. */
const RADIUS = 0.25;
const HEIGHT = 2;

/** The distance above and below the middle over which the two joints share the tube, in meters. */
const BLEND_HALF_LENGTH = 0.3;

const SEGMENTS = 64;
const WALL_RINGS = 81;
/** The number of rings in each rounded end, without the pole. */
const END_RINGS = 8;

/** A ring of the outline: its height and its radius, in meters. */
type Ring = readonly [height: number, radius: number];

/** From the ring next to the lower pole to the ring next to the upper pole. */
function outline(): Ring[] {
  const rings: Ring[] = [];
  for (let ring = 1; ring <= END_RINGS; ring++) {
    const angle = (ring / END_RINGS) * (Math.PI / 2);
    rings.push([RADIUS * (1 - Math.cos(angle)), RADIUS * Math.sin(angle)]);
  }
  const wallHeight = HEIGHT - 2 * RADIUS;
  for (let ring = 1; ring < WALL_RINGS; ring++) {
    rings.push([RADIUS + (wallHeight * ring) / WALL_RINGS, RADIUS]);
  }
  for (let ring = END_RINGS; ring >= 1; ring--) {
    const angle = (ring / END_RINGS) * (Math.PI / 2);
    rings.push([HEIGHT - RADIUS * (1 - Math.cos(angle)), RADIUS * Math.sin(angle)]);
  }
  return rings;
}

/** Returns 0 below the blend, 1 above it, and a cubic with level ends in between. */
function upperWeight(height: number): number {
  const along = (height - HEIGHT / 2) / (2 * BLEND_HALF_LENGTH) + 0.5;
  const t = Math.min(1, Math.max(0, along));
  return t * t * (3 - 2 * t);
}

/**
 * Lists vertices ring by ring, with the poles last. Texture coordinates have one more column than
 * there are segments, so that u runs from 0 to 1 around the tube; v is the height divided by the
 * tube's height.
 */
function buildWall(rings: readonly Ring[]): SourceMesh {
  const positions: Vector3[] = [];
  const textureCoordinates: Vector2[] = [];
  for (const [height, radius] of rings) {
    for (let segment = 0; segment <= SEGMENTS; segment++) {
      const angle = (segment / SEGMENTS) * 2 * Math.PI;
      // The seam is at the back (-z). Seen from above, u runs counterclockwise.
      const point: Vector3 = [-radius * Math.sin(angle), height, -radius * Math.cos(angle)];
      if (segment < SEGMENTS) positions.push(point);
      textureCoordinates.push([segment / SEGMENTS, height / HEIGHT]);
    }
  }
  const at = (ring: number, segment: number): Corner => ({
    position: ring * SEGMENTS + (segment % SEGMENTS),
    texture: ring * (SEGMENTS + 1) + segment,
  });
  const faces: Face[] = [];
  for (let ring = 0; ring + 1 < rings.length; ring++) {
    for (let segment = 0; segment < SEGMENTS; segment++) {
      faces.push([
        at(ring, segment),
        at(ring, segment + 1),
        at(ring + 1, segment + 1),
        at(ring + 1, segment),
      ]);
    }
  }
  // A pole has one texture coordinate per triangle, centered on it, so that no chart twists.
  for (const [ring, height] of [
    [0, 0],
    [rings.length - 1, HEIGHT],
  ] as const) {
    const pole = positions.push([0, height, 0]) - 1;
    for (let segment = 0; segment < SEGMENTS; segment++) {
      const texture = textureCoordinates.push([(segment + 0.5) / SEGMENTS, height / HEIGHT]) - 1;
      const tip = { position: pole, texture };
      const here = at(ring, segment);
      const next = at(ring, segment + 1);
      faces.push(height === 0 ? [tip, next, here] : [tip, here, next]);
    }
  }
  return { positions, textureCoordinates, parts: [{ name: 'tube', faces }] };
}

/**
 * Makes the tube of skinning papers: two joints on one axis, with weights that blend around the
 * middle. Rotating the upper joint about y by half a turn collapses the tube to a point under
 * linear blend skinning (the candy-wrapper artifact). Joint 0 is a root without weights at the
 * base.
 */
export function makeTube(dataFolder: string): void {
  const mesh = buildWall(outline());
  const weightsOf = (vertex: number): number[] => {
    const upper = upperWeight(mesh.positions[vertex]![1]);
    return [1 - upper, upper];
  };
  const joints: Vector3[] = [
    [0, 0, 0],
    [0, 0, 0],
    [0, HEIGHT / 2, 0],
  ];
  writeCharacter(dataFolder, 'tube', { joints, parents: [-1, 0, 1], mesh, weightsOf });
}
