/**
 * What surrounds each place of a surface, in compressed sparse rows. A place is a vertex, or
 * several that coincide.
 */
export interface SurfaceRings {
  readonly placeCount: number;
  /** (placeCount + 1) where each place's neighbors start. */
  readonly ringStart: Uint32Array;
  /**
   * The places at the other ends of each place's edges, each once. On an open boundary only those
   * along it, so that smoothing does not pull the boundary inwards.
   */
  readonly ring: Uint32Array;
  /** (placeCount + 1) where each place's corners start, in triangles. */
  readonly fanStart: Uint32Array;
  /** The two other corners of each triangle around a place, counterclockwise. */
  readonly fan: Uint32Array;
}

/**
 * Finds what surrounds each place. An edge is on a boundary if exactly one triangle has it.
 * Triangles with two corners at one place are left out.
 *
 * @param corners (triangleCount × 3) places, counterclockwise
 */
export function surroundPlaces(corners: Uint32Array, placeCount: number): SurfaceRings {
  const { start: fanStart, fan } = collectFans(corners, placeCount);
  const ringStart = new Uint32Array(placeCount + 1);
  const ring: number[] = [];
  /** The number of triangles at each edge of the present place, by the edge's other end. */
  const triangles = new Uint32Array(placeCount);
  for (let place = 0; place < placeCount; place++) {
    const first = fanStart[place]! * 2;
    const end = fanStart[place + 1]! * 2;
    for (let i = first; i < end; i++) triangles[fan[i]!]!++;
    let isOnBoundary = false;
    for (let i = first; i < end; i++) isOnBoundary ||= triangles[fan[i]!] === 1;
    for (let i = first; i < end; i++) {
      const count = triangles[fan[i]!]!;
      if (isOnBoundary ? count === 1 : count > 0) ring.push(fan[i]!);
      // The next triangle with the same edge finds it taken.
      triangles[fan[i]!] = 0;
    }
    ringStart[place + 1] = ring.length;
  }
  return { placeCount, ringStart, ring: Uint32Array.from(ring), fanStart, fan };
}

function collectFans(
  corners: Uint32Array,
  placeCount: number,
): { start: Uint32Array; fan: Uint32Array } {
  const start = new Uint32Array(placeCount + 1);
  forEachCorner(corners, (place) => start[place + 1]!++);
  for (let place = 0; place < placeCount; place++) {
    start[place + 1]! += start[place]!;
  }
  const fan = new Uint32Array(start[placeCount]! * 2);
  const next = start.slice(0, placeCount);
  forEachCorner(corners, (place, second, third) => {
    const at = next[place]!++ * 2;
    fan[at] = second;
    fan[at + 1] = third;
  });
  return { start, fan };
}

function forEachCorner(
  corners: Uint32Array,
  visit: (place: number, second: number, third: number) => void,
): void {
  for (let first = 0; first < corners.length; first += 3) {
    const a = corners[first]!;
    const b = corners[first + 1]!;
    const c = corners[first + 2]!;
    if (a === b || b === c || c === a) continue;
    visit(a, b, c);
    visit(b, c, a);
    visit(c, a, b);
  }
}
