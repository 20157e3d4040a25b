import { firstEqualFloats } from '../core/equal-tuples.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { type Coincident, groupCoincident, partsSomewhere } from './coincident.ts';
import { smoothPlaces } from './smooth-places.ts';
import { type SurfaceRings, surroundPlaces } from './surface-rings.ts';
import { faceArea, type FramedSurface, frameSurface } from './surface-turns.ts';

/** A mesh as delta mush sees it: places, each with the vertices that coincide there. */
export interface MushedSurface {
  readonly rings: SurfaceRings;
  /** (pointCount) the place of each point. */
  readonly placeOf: Uint32Array;
  /** (placeCount + 1) where each place's render vertices start in `vertices`. */
  readonly vertexStart: Uint32Array;
  /** (vertexCount) */
  readonly vertices: Uint32Array;
  /** The mesh at rest before smoothing. */
  readonly plain: FramedSurface;
  /** (placeCount × 3) what linear blend makes of the places; overwritten for each pose. */
  readonly skinned: Float64Array;
  /** (placeCount × 3) overwritten for each pose. */
  readonly work: readonly [Float64Array, Float64Array];
  /** Those of the last few settings. */
  readonly rests: MushedRest[];
}

/** The smoothed mesh at rest, before corrections such as morphs. */
export interface MushedRest {
  readonly steps: number;
  readonly lambda: number;
  readonly smoothed: FramedSurface;
  /**
   * (placeCount) 1 where the smoothed faces around a place are so small beside its way from there
   * that the way back would magnify rounding: such a place stays where linear blend puts it.
   */
  readonly isCollapsed: Uint8Array;
}

/** As many as there are views beside each other, each of which may have settings of its own. */
const keptRests = 4;
/** The largest ratio of a place's way to the square root of its faces' area. */
const largestReach = 32;
/** Two sides of a sheet coincide with opposite normals; each is a surface of its own. */
const oppositeCosine = -0.95;

const surfaces = new WeakMap<Skin, MushedSurface>();
const latest = new WeakMap<Mesh, MushedSurface>();

/** @param mesh before its rest layers */
export function surfaceOf(mesh: Mesh, skin: Skin): MushedSurface {
  let surface = surfaces.get(skin);
  if (!surface) surfaces.set(skin, (surface = createSurface(mesh, skin)));
  return surface;
}

/** Weights that are edited keep the surface, unless they part what coincides. */
function createSurface(mesh: Mesh, skin: Skin): MushedSurface {
  const coincident = findPlaces(mesh, skin);
  const former = latest.get(mesh);
  if (former?.placeOf.every((place, point) => place === coincident.groupOf[point])) return former;
  const surface = surfaceOfPlaces(mesh, coincident);
  latest.set(mesh, surface);
  return surface;
}

function findPlaces({ pointCount, positions, normals }: Mesh, skin: Skin): Coincident {
  const first = firstEqualFloats(positions.subarray(0, pointCount * 3), 3);
  return groupCoincident(first, (a, b) => {
    const [i, j] = [a * 3, b * 3];
    const cosine =
      normals[i]! * normals[j]! +
      normals[i + 1]! * normals[j + 1]! +
      normals[i + 2]! * normals[j + 2]!;
    return cosine < oppositeCosine || partsSomewhere(skin, a, b);
  });
}

function surfaceOfPlaces(
  { vertexCount, pointOf, indices, positions }: Mesh,
  { groupOf: placeOf, groupCount }: Coincident,
): MushedSurface {
  const corners = indices.map((vertex) => placeOf[pointOf[vertex]!]!);
  const rings = surroundPlaces(corners, groupCount);
  const vertexStart = new Uint32Array(groupCount + 1);
  for (const point of pointOf) vertexStart[placeOf[point]! + 1]!++;
  for (let place = 0; place < groupCount; place++) vertexStart[place + 1]! += vertexStart[place]!;
  const vertices = new Uint32Array(vertexCount);
  const next = vertexStart.slice();
  const places = new Float64Array(groupCount * 3);
  for (let vertex = 0; vertex < vertexCount; vertex++) {
    const place = placeOf[pointOf[vertex]!]!;
    vertices[next[place]!++] = vertex;
    for (let axis = 0; axis < 3; axis++) {
      places[place * 3 + axis] = positions[vertex * 3 + axis]!;
    }
  }
  return {
    rings,
    placeOf,
    vertexStart,
    vertices,
    plain: frameSurface(rings, places),
    skinned: new Float64Array(groupCount * 3),
    work: [new Float64Array(groupCount * 3), new Float64Array(groupCount * 3)],
    rests: [],
  };
}

/** Smooths the mesh at rest, once for each settings. */
export function restOf(surface: MushedSurface, steps: number, lambda: number): MushedRest {
  const { rests } = surface;
  for (let i = 0; i < rests.length; i++) {
    if (rests[i]!.steps === steps && rests[i]!.lambda === lambda) return rests[i]!;
  }
  if (rests.length === keptRests) rests.shift();
  const rest = smoothRest(surface, steps, lambda);
  rests.push(rest);
  return rest;
}

function smoothRest(surface: MushedSurface, steps: number, lambda: number): MushedRest {
  const { rings, plain, work } = surface;
  const places = smoothPlaces(rings, plain.places, steps, lambda, work).slice();
  const isCollapsed = new Uint8Array(rings.placeCount);
  for (let place = 0; place < rings.placeCount; place++) {
    const at = place * 3;
    const way = Math.hypot(
      plain.places[at]! - places[at]!,
      plain.places[at + 1]! - places[at + 1]!,
      plain.places[at + 2]! - places[at + 2]!,
    );
    const room = largestReach * Math.sqrt(faceArea(rings, places, place));
    isCollapsed[place] = way > room ? 1 : 0;
  }
  return { steps, lambda, smoothed: frameSurface(rings, places), isCollapsed };
}
