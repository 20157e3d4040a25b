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
  if (corners.length === 3) return fan(3);
  if (corners.length === 4) {
    const from = quadStart(positions, corners[0]!, corners[1]!, corners[2]!, corners[3]!);
    return fan(4, from);
  }
  const outline = projectToPlane(positions, corners);
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

/**
 * The corner (0 to 3) at which both triangles of a quad start: the one that points inward, of which a quad
 * has at most one, else the first. Meshes are made of quads, so nothing is allocated here, not even
 * arrays to take apart, which code that is still cold does create.
 *
 * @param positions xyz triples
 * @param a a to d: indices of positions, in order around the face
 */
export function quadStart(
  positions: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
  d: number,
): 0 | 1 | 2 | 3 {
  const normalX = newellTerm(positions, a, b, c, d, 1, 2);
  const normalY = newellTerm(positions, a, b, c, d, 2, 0);
  const normalZ = newellTerm(positions, a, b, c, d, 0, 1);
  const x = Math.abs(normalX);
  const y = Math.abs(normalY);
  const z = Math.abs(normalZ);
  const dropped = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  const u = (dropped + 1) % 3;
  const v = (dropped + 2) % 3;
  const flip = (dropped === 0 ? normalX : dropped === 1 ? normalY : normalZ) < 0 ? -1 : 1;
  const au = positions[a * 3 + u]!;
  const av = positions[a * 3 + v]! * flip;
  const bu = positions[b * 3 + u]!;
  const bv = positions[b * 3 + v]! * flip;
  const cu = positions[c * 3 + u]!;
  const cv = positions[c * 3 + v]! * flip;
  const du = positions[d * 3 + u]!;
  const dv = positions[d * 3 + v]! * flip;
  const inwardA = cross(du, dv, au, av, bu, bv) < 0;
  const inwardB = cross(au, av, bu, bv, cu, cv) < 0;
  const inwardC = cross(bu, bv, cu, cv, du, dv) < 0;
  const inwardD = cross(cu, cv, du, dv, au, av) < 0;
  if (Number(inwardA) + Number(inwardB) + Number(inwardC) + Number(inwardD) !== 1) return 0;
  return inwardA ? 0 : inwardB ? 1 : inwardC ? 2 : 3;
}

/** One component of a quad's Newell normal, from the two coordinates that it is perpendicular to. */
function newellTerm(
  positions: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
  d: number,
  u: number,
  v: number,
): number {
  const au = positions[a * 3 + u]!;
  const av = positions[a * 3 + v]!;
  const bu = positions[b * 3 + u]!;
  const bv = positions[b * 3 + v]!;
  const cu = positions[c * 3 + u]!;
  const cv = positions[c * 3 + v]!;
  const du = positions[d * 3 + u]!;
  const dv = positions[d * 3 + v]!;
  return (
    (au - bu) * (av + bv) + (bu - cu) * (bv + cv) + (cu - du) * (cv + dv) + (du - au) * (dv + av)
  );
}

/** All triangles of a polygon that start at one of its corners. */
function fan(cornerCount: number, from = 0): number[] {
  const triangles: number[] = [];
  for (let i = 2; i < cornerCount; i++) {
    triangles.push(from, (from + i - 1) % cornerCount, (from + i) % cornerCount);
  }
  return triangles;
}

/** xy pairs, counterclockwise when seen against the normal. */
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
  return cross(ax, ay, bx, by, cx, cy);
}

/** Twice the signed area of a triangle from its coordinates. */
function cross(ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number {
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}
