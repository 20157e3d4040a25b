/**
 * Cuts a polygon into triangles that keep its orientation: a fan if it is convex, otherwise ear
 * clipping in the plane of its Newell normal.
 *
 * @param positions xyz triples
 * @param corners indices of positions, in order around the face
 * @param earClip cuts an outline (xy pairs) into triples of its corners; without it every face is a
 * fan
 * @returns triples of indices into `corners`
 */
export function triangulate(
  positions: ArrayLike<number>,
  corners: readonly number[],
  earClip?: (outline: readonly number[]) => number[],
): number[] {
  if (corners.length === 3) return [0, 1, 2];
  const outline = projectToPlane(positions, corners);
  if (corners.length === 4) return cutQuad(outline);
  if (!earClip || isConvex(outline)) return fan(corners.length);
  const ears = earClip(outline);
  return ears.length === (corners.length - 2) * 3 ? orient(ears, outline) : fan(corners.length);
}

/** Whether a polygon can't be cut as a fan: it has five corners or more and is not convex. */
export function needsEarClipping(
  positions: ArrayLike<number>,
  corners: readonly number[],
): boolean {
  return corners.length > 4 && !isConvex(projectToPlane(positions, corners));
}

/** A quad has at most one reflex corner; both of its triangles start there. */
function cutQuad(outline: readonly number[]): number[] {
  const turnAt = (corner: number): number =>
    turn(outline, (corner + 3) % 4, corner, (corner + 1) % 4);
  const inward = [0, 1, 2, 3].filter((corner) => turnAt(corner) < 0);
  const [from = 0] = inward.length === 1 ? inward : [];
  return [0, 1, 2, 0, 2, 3].map((corner) => (from + corner) % 4);
}

function fan(cornerCount: number): number[] {
  const triangles: number[] = [];
  for (let i = 2; i < cornerCount; i++) triangles.push(0, i - 1, i);
  return triangles;
}

/** xy pairs, counter-clockwise when seen against the normal. */
function projectToPlane(positions: ArrayLike<number>, corners: readonly number[]): number[] {
  const normal = newellNormal(positions, corners);
  const size = normal.map(Math.abs);
  const dropped = size.indexOf(Math.max(...size));
  const [u, v] = [(dropped + 1) % 3, (dropped + 2) % 3];
  const flip = normal[dropped]! < 0 ? -1 : 1;
  return corners.flatMap((corner) => [
    positions[corner * 3 + u]!,
    positions[corner * 3 + v]! * flip,
  ]);
}

/**
 * Twice the polygon's area times its unit normal (Newell's method); also works for polygons that
 * are not planar.
 */
function newellNormal(positions: ArrayLike<number>, corners: readonly number[]): number[] {
  const normal = [0, 0, 0];
  corners.forEach((corner, index) => {
    const a = corner * 3;
    const b = corners[(index + 1) % corners.length]! * 3;
    for (let i = 0; i < 3; i++) {
      const [u, v] = [(i + 1) % 3, (i + 2) % 3];
      const difference = positions[a + u]! - positions[b + u]!;
      normal[i]! += difference * (positions[a + v]! + positions[b + v]!);
    }
  });
  return normal;
}

function isConvex(outline: readonly number[]): boolean {
  const count = outline.length / 2;
  for (let i = 0; i < count; i++) {
    if (turn(outline, i, (i + 1) % count, (i + 2) % count) < 0) return false;
  }
  return true;
}

function orient(triangles: number[], outline: readonly number[]): number[] {
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [triangles[i]!, triangles[i + 1]!, triangles[i + 2]!];
    if (turn(outline, a, b, c) < 0) [triangles[i + 1], triangles[i + 2]] = [c, b];
  }
  return triangles;
}

/** Twice the signed area of triangle a b c: positive if it turns left. */
function turn(outline: readonly number[], a: number, b: number, c: number): number {
  const [ax, ay] = [outline[a * 2]!, outline[a * 2 + 1]!];
  const [bx, by] = [outline[b * 2]!, outline[b * 2 + 1]!];
  const [cx, cy] = [outline[c * 2]!, outline[c * 2 + 1]!];
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}
