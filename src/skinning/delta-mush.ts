import { flushSubnormal } from '../core/float32.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { linearBlend } from './linear-blend.ts';
import {
  type MethodParameter,
  type MethodSettings,
  type MethodUse,
  type PosedStreams,
  settingOf,
  type SkinningMethod,
} from './method.ts';
import { type MushedRest, type MushedSurface, restOf, surfaceOf } from './mushed-surface.ts';
import { smoothPlaces } from './smooth-places.ts';
import { writeTurn } from './surface-turns.ts';

const steps: MethodParameter = {
  name: 'steps',
  label: 'Smoothing steps',
  help: 'How often the skin is smoothed; more steps reach further over the surface.',
  least: 0,
  most: 50,
  step: 1,
  initial: 15,
};

const lambda: MethodParameter = {
  name: 'lambda',
  label: 'Smoothing λ',
  help: 'How far a vertex moves to the mean of its neighbors in each step.',
  least: 0,
  most: 1,
  step: 0.05,
  initial: 0.5,
};

/**
 * Delta mush (Mancewicz, Derksen, Rijpkema and Wilson 2014, "Delta Mush: smoothing deformations
 * while preserving detail"): p′ = S(X′) + R · (p − S(X)). X is the mesh and X′ what linear blend
 * makes of it, S smooths a surface, R turns the smoothed surface at rest to the posed one, and p is
 * the vertex after the rest layers, so that these are not smoothed away.
 *
 * Normals are those at rest, turned by R too: unlike recomputed ones they keep a file's creases,
 * and are exact at rest.
 */
export const deltaMush: SkinningMethod<'delta-mush'> = {
  ...linearBlend,
  id: 'delta-mush',
  parameters: [steps, lambda],
  finish,
  *warmUp(mesh, skin, settings) {
    const surface = surfaceOf(mesh, skin);
    yield;
    smoothedRest(surface, settings);
    yield;
  },
};

function finish(
  mesh: Mesh,
  rest: Mesh,
  skin: Skin,
  posed: PosedStreams,
  { settings }: MethodUse,
): void {
  const mushed = mushSurface(surfaceOf(mesh, skin), posed.positions, settings);
  const { rings, vertexStart, vertices } = mushed.surface;
  for (let place = 0; place < rings.placeCount; place++) {
    const isTurned = turnPlace(mushed, place, turn);
    const { from, to } = endsOf(mushed, place);
    for (let i = vertexStart[place]!; i < vertexStart[place + 1]!; i++) {
      const at = vertices[i]! * 3;
      moveVertex(rest.positions, at, from, to, place * 3, posed.positions);
      if (posed.normals && isTurned) turnNormal(rest.normals, at, posed.normals);
    }
  }
}

/** A posed surface and its smoothed forms. */
export interface Mushed extends MushedRest {
  readonly surface: MushedSurface;
  /** (placeCount × 3) smoothed in the pose. */
  readonly posed: Float64Array;
}

/**
 * Smooths a surface in a pose; the result is overwritten for the next one.
 *
 * @param positions (vertexCount × 3) what linear blend makes of the mesh
 */
export function mushSurface(
  surface: MushedSurface,
  positions: Float32Array,
  settings: MethodSettings,
): Mushed {
  const rest = smoothedRest(surface, settings);
  gatherPlaces(surface, positions);
  const posed = smoothPlaces(surface.rings, surface.skinned, rest.steps, rest.lambda, surface.work);
  return { ...rest, surface, posed };
}

function smoothedRest(surface: MushedSurface, settings: MethodSettings): MushedRest {
  return restOf(surface, Math.round(settingOf(settings, steps)), settingOf(settings, lambda));
}

/** The places (placeCount × 3) from which and to which a place takes the surface around it. */
export function endsOf({ surface, isCollapsed, smoothed, posed }: Mushed, place: number) {
  return isCollapsed[place] === 1
    ? { from: surface.plain.places, to: surface.skinned }
    : { from: smoothed.places, to: posed };
}

/**
 * Finds how the surface turns at a place.
 *
 * @param turn (9) written, row by row; the identity if it does not turn
 * @returns whether there is a rotation
 */
export function turnPlace(
  { surface, isCollapsed, smoothed, posed }: Mushed,
  place: number,
  turn: Float64Array,
): boolean {
  const { rings, plain, skinned } = surface;
  const isTurned =
    (isCollapsed[place] !== 1 && writeTurn(rings, smoothed, posed, place, turn)) ||
    writeTurn(rings, plain, skinned, place, turn);
  if (!isTurned) turn.set(noTurn);
  return isTurned;
}

/** (9) the rotation of the present place, row by row. */
const turn = new Float64Array(9);
const noTurn = Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

/** Writes the mean of each place's vertices to `skinned`. */
function gatherPlaces(
  { rings, vertexStart, vertices, skinned }: MushedSurface,
  positions: Float32Array,
): void {
  for (let place = 0; place < rings.placeCount; place++) {
    let x = 0;
    let y = 0;
    let z = 0;
    const first = vertexStart[place]!;
    const end = vertexStart[place + 1]!;
    for (let i = first; i < end; i++) {
      const at = vertices[i]! * 3;
      x += positions[at]!;
      y += positions[at + 1]!;
      z += positions[at + 2]!;
    }
    skinned[place * 3] = x / (end - first);
    skinned[place * 3 + 1] = y / (end - first);
    skinned[place * 3 + 2] = z / (end - first);
  }
}

/** Writes `to + turn · (p − from)` of the vertex that begins at `at`. */
function moveVertex(
  rest: Float32Array,
  at: number,
  from: Float64Array,
  to: Float64Array,
  place: number,
  out: Float32Array,
): void {
  const x = rest[at]! - from[place]!;
  const y = rest[at + 1]! - from[place + 1]!;
  const z = rest[at + 2]! - from[place + 2]!;
  out[at] = flushSubnormal(to[place]! + turn[0]! * x + turn[1]! * y + turn[2]! * z);
  out[at + 1] = flushSubnormal(to[place + 1]! + turn[3]! * x + turn[4]! * y + turn[5]! * z);
  out[at + 2] = flushSubnormal(to[place + 2]! + turn[6]! * x + turn[7]! * y + turn[8]! * z);
}

function turnNormal(rest: Float32Array, at: number, out: Float32Array): void {
  const x = rest[at]!;
  const y = rest[at + 1]!;
  const z = rest[at + 2]!;
  out[at] = flushSubnormal(turn[0]! * x + turn[1]! * y + turn[2]! * z);
  out[at + 1] = flushSubnormal(turn[3]! * x + turn[4]! * y + turn[5]! * z);
  out[at + 2] = flushSubnormal(turn[6]! * x + turn[7]! * y + turn[8]! * z);
}
