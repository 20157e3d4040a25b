import { computeVertexNormals } from '../../../src/core/vertex-normals.ts';
import { abdomenSurface, thoraxSurface } from './body.ts';
import { antennaSurface, eyeSurface, headSurface, mandibleSurface } from './head.ts';
import { legSurface } from './leg-surface.ts';
import { legs } from './legs.ts';
import { joined, mirrored, type Surface } from './sweep.ts';
import { wingSurface } from './wings.ts';

/** The weights of the morph targets, each 0 as bound and 1 at the target. */
export interface Shape {
  /** The abdomen swells. */
  readonly breath: number;
  /** The mandibles open and the antennae rise. */
  readonly alert: number;
}

/** The whole insect as it is bound, made of closed surfaces that intersect each other. */
export function insectSurface({ breath, alert }: Shape): Surface {
  const left = [
    eyeSurface(),
    mandibleSurface(alert),
    antennaSurface(alert),
    wingSurface(),
    ...legs.map(legSurface),
  ];
  const pairs = left.flatMap((surface) => [surface, mirrored(surface)]);
  return joined([thoraxSurface(), abdomenSurface(breath), headSurface(), ...pairs]);
}

/** Rounds to a number of decimals, and never to a negative zero. */
export function rounded(values: Iterable<number>, decimals: number): number[] {
  const steps = 10 ** decimals;
  return Array.from(values, (value) => Math.round(value * steps) / steps + 0);
}

/** @returns (vertexCount × 3) unit normals with three decimals */
export function normalsOf({ positions, triangles }: Surface): number[] {
  const normals = new Float32Array(positions.length * 3);
  const indices = Uint32Array.from(triangles.flat());
  computeVertexNormals(Float32Array.from(positions.flat()), indices, normals);
  return rounded(normals, 3);
}
