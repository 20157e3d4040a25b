import { roundWeights, type ObjPart } from './mit-text.ts';
import type { Vector2, Vector3 } from './vector.ts';
import { writeCharacter } from './write-character.ts';

/** Metres. The tube stands on the origin along +y, rounded at both ends. */
const RADIUS = 0.25;
const HEIGHT = 2;

/** How far above and below the middle the two joints share the tube, metres. */
const BLEND_HALF_LENGTH = 0.3;

const SEGMENTS = 64;
const WALL_RINGS = 81;
/** Rings in each rounded end, the pole not counted. */
const END_RINGS = 8;

/** A ring of the outline: its height and its radius, metres. */
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

/** 0 below the blend, 1 above it, and smooth (the cubic with level ends) in between. */
function upperWeight(height: number): number {
  const along = (height - HEIGHT / 2) / (2 * BLEND_HALF_LENGTH) + 0.5;
  const t = Math.min(1, Math.max(0, along));
  return t * t * (3 - 2 * t);
}

interface Wall {
  readonly positions: Vector3[];
  readonly textureCoordinates: Vector2[];
  readonly faces: (readonly (readonly [number, number])[])[];
}

/**
 * Vertices ring by ring, the poles last. Texture coordinates have one column more than there are
 * segments, so that u runs from 0 to 1 round the tube; v is the height over the tube's height.
 */
function buildWall(rings: readonly Ring[]): Wall {
  const positions: Vector3[] = [];
  const textureCoordinates: Vector2[] = [];
  for (const [height, radius] of rings) {
    for (let segment = 0; segment <= SEGMENTS; segment++) {
      const angle = (segment / SEGMENTS) * 2 * Math.PI;
      // The seam is at the back (-z); seen from above, u runs counter-clockwise.
      const point: Vector3 = [-radius * Math.sin(angle), height, -radius * Math.cos(angle)];
      if (segment < SEGMENTS) positions.push(point);
      textureCoordinates.push([segment / SEGMENTS, height / HEIGHT]);
    }
  }
  const at = (ring: number, segment: number): readonly [number, number] => [
    ring * SEGMENTS + (segment % SEGMENTS),
    ring * (SEGMENTS + 1) + segment,
  ];
  const faces: (readonly (readonly [number, number])[])[] = [];
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
  // A pole has a texture coordinate for each triangle, in the middle of it, so that no chart twists.
  for (const [ring, height] of [
    [0, 0],
    [rings.length - 1, HEIGHT],
  ] as const) {
    const pole = positions.push([0, height, 0]) - 1;
    for (let segment = 0; segment < SEGMENTS; segment++) {
      const texture = textureCoordinates.push([(segment + 0.5) / SEGMENTS, height / HEIGHT]) - 1;
      const tip = [pole, texture] as const;
      const here = at(ring, segment);
      const next = at(ring, segment + 1);
      faces.push(height === 0 ? [tip, next, here] : [tip, here, next]);
    }
  }
  return { positions, textureCoordinates, faces };
}

/**
 * Makes the tube of skinning papers: two joints on one axis, weights that blend about the middle.
 * Turning the upper joint about y by half a turn closes the tube to a point under linear blend
 * skinning (the candy wrapper). Joint 0 is a root without weights at the base.
 */
export function makeTube(dataFolder: string): void {
  const { positions, textureCoordinates, faces } = buildWall(outline());
  const part: ObjPart = { name: 'tube', faces };
  const rows = positions.map((point) => {
    const upper = upperWeight(point[1]);
    return roundWeights([1 - upper, upper]);
  });
  const joints: Vector3[] = [
    [0, 0, 0],
    [0, 0, 0],
    [0, HEIGHT / 2, 0],
  ];
  const obj = { positions, textureCoordinates, parts: [part] };
  writeCharacter(dataFolder, 'tube', { joints, parents: [-1, 0, 1], obj, rows });
}
