// The skinning kernels for WebAssembly, in AssemblyScript. They compute what blend-matrices.ts,
// affine-kernel.ts, joint-normals.ts, blend-quaternions.ts, blend-motions.ts and
// centers-of-rotation.ts of src/skinning define, with the same operations in the same order, for
// four vertices at a time: a vector has one number of each. Change one with the other.
//
// The host lays out the memory (wasm-skin.ts). A group is four vertices with as many influences:
// - influences: for each influence of the group, 4 weights (float32) and 4 palette entries (uint16)
// - points and normals: 4 x, 4 y and 4 z
// - targets: where each vertex is written, in bytes from the start of the results (uint32)
// - matrices: 12 vectors, the 3 × 4 matrices of the group row by row

@inline const influenceBytes: usize = 24;
@inline const groupBytes: usize = 48;
@inline const targetBytes: usize = 16;
@inline const matrixBytes: usize = 192;

/**
 * Blends the matrices of groups that have `count` influences, from left to right. An entry of the
 * palette has `stride` bytes.
 */
export function blendMatrices(
  groups: i32,
  count: i32,
  influences: usize,
  palette: usize,
  stride: usize,
  matrices: usize,
): void {
  for (; groups > 0; groups--) {
    // Two vertices at a time, whose rows stay in registers.
    let a0 = zero(), a1 = zero(), a2 = zero();
    let b0 = zero(), b1 = zero(), b2 = zero();
    for (let i = 0, at = influences; i < count; i++, at += influenceBytes) {
      let weight = v128.load32_splat(at);
      let entry = palette + <usize>load<u16>(at, 16) * stride;
      a0 = f32x4.add(a0, f32x4.mul(weight, v128.load(entry)));
      a1 = f32x4.add(a1, f32x4.mul(weight, v128.load(entry, 16)));
      a2 = f32x4.add(a2, f32x4.mul(weight, v128.load(entry, 32)));
      weight = v128.load32_splat(at, 4);
      entry = palette + <usize>load<u16>(at, 18) * stride;
      b0 = f32x4.add(b0, f32x4.mul(weight, v128.load(entry)));
      b1 = f32x4.add(b1, f32x4.mul(weight, v128.load(entry, 16)));
      b2 = f32x4.add(b2, f32x4.mul(weight, v128.load(entry, 32)));
    }
    let c0 = zero(), c1 = zero(), c2 = zero();
    let d0 = zero(), d1 = zero(), d2 = zero();
    for (let i = 0, at = influences; i < count; i++, at += influenceBytes) {
      let weight = v128.load32_splat(at, 8);
      let entry = palette + <usize>load<u16>(at, 20) * stride;
      c0 = f32x4.add(c0, f32x4.mul(weight, v128.load(entry)));
      c1 = f32x4.add(c1, f32x4.mul(weight, v128.load(entry, 16)));
      c2 = f32x4.add(c2, f32x4.mul(weight, v128.load(entry, 32)));
      weight = v128.load32_splat(at, 12);
      entry = palette + <usize>load<u16>(at, 22) * stride;
      d0 = f32x4.add(d0, f32x4.mul(weight, v128.load(entry)));
      d1 = f32x4.add(d1, f32x4.mul(weight, v128.load(entry, 16)));
      d2 = f32x4.add(d2, f32x4.mul(weight, v128.load(entry, 32)));
    }
    influences += <usize>count * influenceBytes;
    storeTransposed(matrices, a0, b0, c0, d0);
    storeTransposed(matrices + 64, a1, b1, c1, d1);
    storeTransposed(matrices + 128, a2, b2, c2, d2);
    matrices += matrixBytes;
  }
}

/**
 * Writes the signed palette: for each pair of a pivot and an entry, the bytes of the entry from
 * `from` on. Those from its rotation on are reversed if it points away from that of the pivot.
 *
 * @param pairs two palette entries each (uint16)
 * @param from at most `rotation`, where an entry has its rotation; both in bytes, as `stride`
 */
export function signPalette(
  count: i32,
  pairs: usize,
  palette: usize,
  stride: usize,
  rotation: usize,
  from: usize,
  out: usize,
): void {
  for (; count > 0; count--, pairs += 4) {
    const pivot = palette + <usize>load<u16>(pairs) * stride + rotation;
    const entry = palette + <usize>load<u16>(pairs, 2) * stride;
    const turn = entry + rotation;
    const three =
      load<f32>(pivot) * load<f32>(turn) +
      load<f32>(pivot, 4) * load<f32>(turn, 4) +
      load<f32>(pivot, 8) * load<f32>(turn, 8);
    const away = three + load<f32>(pivot, 12) * load<f32>(turn, 12) < 0;
    const reversed = f32x4.splat(away ? -0.0 : 0.0);
    for (let at = from; at < stride; at += 16, out += 16) {
      const numbers = v128.load(entry + at);
      v128.store(out, at < rotation ? numbers : v128.xor(numbers, reversed));
    }
  }
}

/**
 * Blends the dual quaternions of groups that have `count` influences, and writes their motions as
 * matrices. Entries are those of the signed palette, a rotation and a dual part each. Returns
 * whether any blend has no direction; the matrix of such a vertex has no numbers.
 */
export function blendDualQuaternions(
  groups: i32,
  count: i32,
  influences: usize,
  palette: usize,
  matrices: usize,
): bool {
  let isLost = zero();
  for (; groups > 0; groups--) {
    let a0 = zero(), a1 = zero();
    let b0 = zero(), b1 = zero();
    let c0 = zero(), c1 = zero();
    let d0 = zero(), d1 = zero();
    for (let i = 0; i < count; i++, influences += influenceBytes) {
      let weight = v128.load32_splat(influences);
      let entry = palette + (<usize>load<u16>(influences, 16) << 5);
      a0 = f32x4.add(a0, f32x4.mul(weight, v128.load(entry)));
      a1 = f32x4.add(a1, f32x4.mul(weight, v128.load(entry, 16)));
      weight = v128.load32_splat(influences, 4);
      entry = palette + (<usize>load<u16>(influences, 18) << 5);
      b0 = f32x4.add(b0, f32x4.mul(weight, v128.load(entry)));
      b1 = f32x4.add(b1, f32x4.mul(weight, v128.load(entry, 16)));
      weight = v128.load32_splat(influences, 8);
      entry = palette + (<usize>load<u16>(influences, 20) << 5);
      c0 = f32x4.add(c0, f32x4.mul(weight, v128.load(entry)));
      c1 = f32x4.add(c1, f32x4.mul(weight, v128.load(entry, 16)));
      weight = v128.load32_splat(influences, 12);
      entry = palette + (<usize>load<u16>(influences, 22) << 5);
      d0 = f32x4.add(d0, f32x4.mul(weight, v128.load(entry)));
      d1 = f32x4.add(d1, f32x4.mul(weight, v128.load(entry, 16)));
    }
    // The results are written where the matrices will be.
    storeTransposed(matrices, a0, b0, c0, d0);
    storeTransposed(matrices + 64, a1, b1, c1, d1);
    let x = v128.load(matrices);
    let y = v128.load(matrices, 16);
    let z = v128.load(matrices, 32);
    let w = v128.load(matrices, 48);
    const squared = f32x4.add(dot(x, y, z, x, y, z), f32x4.mul(w, w));
    const found = f32x4.ge(squared, f32x4.splat(1e-12));
    isLost = v128.or(isLost, v128.not(found));
    const scale = v128.or(
      f32x4.div(f32x4.splat(1), f32x4.sqrt(squared)),
      v128.not(found), // all bits set are no number
    );
    x = f32x4.mul(x, scale);
    y = f32x4.mul(y, scale);
    z = f32x4.mul(z, scale);
    w = f32x4.mul(w, scale);
    const ex = f32x4.mul(v128.load(matrices, 64), scale);
    const ey = f32x4.mul(v128.load(matrices, 80), scale);
    const ez = f32x4.mul(v128.load(matrices, 96), scale);
    const ew = f32x4.mul(v128.load(matrices, 112), scale);
    storeRotation(matrices, x, y, z, w);
    storeTwice(matrices + 48, f32x4.add(minor(w, ex, ew, x), minor(y, ez, z, ey)));
    storeTwice(matrices + 112, f32x4.add(minor(w, ey, ew, y), minor(z, ex, x, ez)));
    storeTwice(matrices + 176, f32x4.add(minor(w, ez, ew, z), minor(x, ey, y, ex)));
    matrices += matrixBytes;
  }
  return v128.any_true(isLost);
}

/**
 * Changes the blended matrices of groups so that their vertices turn about their centers, by the
 * blend of rotations. Entries are those of the signed palette, a matrix and a rotation each. A
 * vertex without a center, or whose rotations cancel out, keeps its matrix.
 *
 * @param places 4 x, 4 y and 4 z of what the matrices are then applied to, written
 */
export function turnAboutCenters(
  groups: i32,
  count: i32,
  influences: usize,
  palette: usize,
  centers: usize,
  points: usize,
  matrices: usize,
  places: usize,
): void {
  // The group after the block's matrices is room for the rotations.
  const turned = matrices + <usize>groups * matrixBytes;
  for (; groups > 0; groups--) {
    let a = zero(), b = zero(), c = zero(), d = zero();
    for (let i = 0; i < count; i++, influences += influenceBytes) {
      const entryA = palette + (<usize>load<u16>(influences, 16) << 6);
      const entryB = palette + (<usize>load<u16>(influences, 18) << 6);
      const entryC = palette + (<usize>load<u16>(influences, 20) << 6);
      const entryD = palette + (<usize>load<u16>(influences, 22) << 6);
      a = f32x4.add(a, f32x4.mul(v128.load32_splat(influences), v128.load(entryA, 48)));
      b = f32x4.add(b, f32x4.mul(v128.load32_splat(influences, 4), v128.load(entryB, 48)));
      c = f32x4.add(c, f32x4.mul(v128.load32_splat(influences, 8), v128.load(entryC, 48)));
      d = f32x4.add(d, f32x4.mul(v128.load32_splat(influences, 12), v128.load(entryD, 48)));
    }
    storeTransposed(turned, a, b, c, d);
    const x = v128.load(turned);
    const y = v128.load(turned, 16);
    const z = v128.load(turned, 32);
    const w = v128.load(turned, 48);
    const squared = f32x4.add(dot(x, y, z, x, y, z), f32x4.mul(w, w));
    const scale = f32x4.div(f32x4.splat(1), f32x4.sqrt(squared));
    storeRotation(
      turned,
      f32x4.mul(x, scale),
      f32x4.mul(y, scale),
      f32x4.mul(z, scale),
      f32x4.mul(w, scale),
    );
    const cx = v128.load(centers);
    const cy = v128.load(centers, 16);
    const cz = v128.load(centers, 32);
    const turns = v128.and(
      f32x4.gt(squared, f32x4.splat(1e-12)),
      f32x4.lt(cx, f32x4.splat(1e38)),
    );
    for (let row: usize = 0; row < matrixBytes; row += 64) {
      const at = matrices + row;
      const moved = applyRow(at, cx, cy, cz);
      v128.store(at, v128.bitselect(v128.load(turned + row), v128.load(at), turns));
      v128.store(at, v128.bitselect(v128.load(turned + row, 16), v128.load(at, 16), turns), 16);
      v128.store(at, v128.bitselect(v128.load(turned + row, 32), v128.load(at, 32), turns), 32);
      v128.store(at, v128.bitselect(moved, v128.load(at, 48), turns), 48);
    }
    storePlace(places, v128.load(points), cx, turns);
    storePlace(places + 16, v128.load(points, 16), cy, turns);
    storePlace(places + 32, v128.load(points, 32), cz, turns);
    matrices += matrixBytes;
    centers += groupBytes;
    points += groupBytes;
    places += groupBytes;
  }
}

/** Stores a number of each point, relative to its center if it turns about it. */
@inline
function storePlace(at: usize, point: v128, center: v128, turns: v128): void {
  v128.store(at, v128.bitselect(f32x4.sub(point, center), point, turns));
}

/** Transforms points by their matrices. */
export function transformPoints(
  groups: i32,
  matrices: usize,
  points: usize,
  targets: usize,
  out: usize,
): void {
  for (; groups > 0; groups--) {
    const x = v128.load(points);
    const y = v128.load(points, 16);
    const z = v128.load(points, 32);
    storeVectors(
      out,
      targets,
      flushSubnormal(applyRow(matrices, x, y, z)),
      flushSubnormal(applyRow(matrices + 64, x, y, z)),
      flushSubnormal(applyRow(matrices + 128, x, y, z)),
    );
    matrices += matrixBytes;
    points += groupBytes;
    targets += targetBytes;
  }
}

/** Transforms normals by the upper 3 × 3 of their matrices, and normalizes them. */
export function transformNormals(
  groups: i32,
  matrices: usize,
  normals: usize,
  targets: usize,
  out: usize,
): void {
  for (; groups > 0; groups--) {
    const nx = v128.load(normals);
    const ny = v128.load(normals, 16);
    const nz = v128.load(normals, 32);
    storeUnit(
      out,
      targets,
      dot(v128.load(matrices), v128.load(matrices, 16), v128.load(matrices, 32), nx, ny, nz),
      dot(v128.load(matrices, 64), v128.load(matrices, 80), v128.load(matrices, 96), nx, ny, nz),
      dot(v128.load(matrices, 128), v128.load(matrices, 144), v128.load(matrices, 160), nx, ny, nz),
      zero(),
    );
    matrices += matrixBytes;
    normals += groupBytes;
    targets += targetBytes;
  }
}

/** Transforms normals by the cofactors of their matrices, and normalizes them. */
export function transformNormalsByCofactors(
  groups: i32,
  matrices: usize,
  normals: usize,
  targets: usize,
  out: usize,
): void {
  for (; groups > 0; groups--) {
    const ax = v128.load(matrices);
    const ay = v128.load(matrices, 16);
    const az = v128.load(matrices, 32);
    const bx = v128.load(matrices, 64);
    const by = v128.load(matrices, 80);
    const bz = v128.load(matrices, 96);
    const cx = v128.load(matrices, 128);
    const cy = v128.load(matrices, 144);
    const cz = v128.load(matrices, 160);
    const nx = v128.load(normals);
    const ny = v128.load(normals, 16);
    const nz = v128.load(normals, 32);
    const ux = minor(by, cz, bz, cy);
    const uy = minor(bz, cx, bx, cz);
    const uz = minor(bx, cy, by, cx);
    const x = dot(ux, uy, uz, nx, ny, nz);
    const y = dot(minor(cy, az, cz, ay), minor(cz, ax, cx, az), minor(cx, ay, cy, ax), nx, ny, nz);
    const z = dot(minor(ay, bz, az, by), minor(az, bx, ax, bz), minor(ax, by, ay, bx), nx, ny, nz);
    // Reversing the sign bit of the vectors whose determinant is negative is the same as times -1.
    const negative = f32x4.lt(dot(ux, uy, uz, ax, ay, az), zero());
    const side = v128.and(negative, f32x4.splat(-0.0));
    storeUnit(out, targets, x, y, z, side);
    matrices += matrixBytes;
    normals += groupBytes;
    targets += targetBytes;
  }
}

/** Stores the upper 3 × 3 of the matrices of unit quaternions. */
@inline
function storeRotation(at: usize, x: v128, y: v128, z: v128, w: v128): void {
  const one = f32x4.splat(1);
  const x2 = f32x4.add(x, x);
  const y2 = f32x4.add(y, y);
  const z2 = f32x4.add(z, z);
  const xx = f32x4.mul(x, x2);
  const yy = f32x4.mul(y, y2);
  const zz = f32x4.mul(z, z2);
  const xy = f32x4.mul(x, y2);
  const xz = f32x4.mul(x, z2);
  const yz = f32x4.mul(y, z2);
  const wx = f32x4.mul(w, x2);
  const wy = f32x4.mul(w, y2);
  const wz = f32x4.mul(w, z2);
  v128.store(at, f32x4.sub(one, f32x4.add(yy, zz)));
  v128.store(at, f32x4.sub(xy, wz), 16);
  v128.store(at, f32x4.add(xz, wy), 32);
  v128.store(at, f32x4.add(xy, wz), 64);
  v128.store(at, f32x4.sub(one, f32x4.add(xx, zz)), 80);
  v128.store(at, f32x4.sub(yz, wx), 96);
  v128.store(at, f32x4.sub(xz, wy), 128);
  v128.store(at, f32x4.add(yz, wx), 144);
  v128.store(at, f32x4.sub(one, f32x4.add(xx, yy)), 160);
}

@inline
function storeTwice(at: usize, value: v128): void {
  v128.store(at, f32x4.add(value, value));
}

/** Stores vectors with unit length, or +y where one has no direction left. */
@inline
function storeUnit(
  out: usize,
  targets: usize,
  x: v128,
  y: v128,
  z: v128,
  side: v128,
): void {
  const one = f32x4.splat(1);
  const squared = dot(x, y, z, x, y, z);
  const hasDirection = f32x4.gt(squared, f32x4.splat(1e-30));
  const scale = v128.xor(f32x4.div(one, f32x4.sqrt(squared)), side);
  storeVectors(
    out,
    targets,
    v128.and(flushSubnormal(f32x4.mul(x, scale)), hasDirection),
    v128.bitselect(flushSubnormal(f32x4.mul(y, scale)), one, hasDirection),
    v128.and(flushSubnormal(f32x4.mul(z, scale)), hasDirection),
  );
}

/** Stores the four vectors where their vertices are. */
@inline
function storeVectors(out: usize, targets: usize, x: v128, y: v128, z: v128): void {
  const low = v128.shuffle<f32>(x, y, 0, 4, 1, 5);
  const high = v128.shuffle<f32>(x, y, 2, 6, 3, 7);
  const a = out + <usize>load<u32>(targets);
  const b = out + <usize>load<u32>(targets, 4);
  const c = out + <usize>load<u32>(targets, 8);
  const d = out + <usize>load<u32>(targets, 12);
  v128.store64_lane(a, low, 0);
  v128.store32_lane(a, z, 0, 8);
  v128.store64_lane(b, low, 1);
  v128.store32_lane(b, z, 1, 8);
  v128.store64_lane(c, high, 0);
  v128.store32_lane(c, z, 2, 8);
  v128.store64_lane(d, high, 1);
  v128.store32_lane(d, z, 3, 8);
}

/** Stores the columns of four rows: a vector for each place in a row. */
@inline
function storeTransposed(at: usize, a: v128, b: v128, c: v128, d: v128): void {
  const abLow = v128.shuffle<f32>(a, b, 0, 4, 1, 5);
  const abHigh = v128.shuffle<f32>(a, b, 2, 6, 3, 7);
  const cdLow = v128.shuffle<f32>(c, d, 0, 4, 1, 5);
  const cdHigh = v128.shuffle<f32>(c, d, 2, 6, 3, 7);
  v128.store(at, v128.shuffle<f32>(abLow, cdLow, 0, 1, 4, 5));
  v128.store(at, v128.shuffle<f32>(abLow, cdLow, 2, 3, 6, 7), 16);
  v128.store(at, v128.shuffle<f32>(abHigh, cdHigh, 0, 1, 4, 5), 32);
  v128.store(at, v128.shuffle<f32>(abHigh, cdHigh, 2, 3, 6, 7), 48);
}

/** GPUs flush subnormal numbers to zero; see src/core/float32.ts. */
@inline
function flushSubnormal(value: v128): v128 {
  const magnitude = v128.and(value, i32x4.splat(0x7fffffff));
  return v128.andnot(value, f32x4.lt(magnitude, f32x4.splat(1.2e-38)));
}

@inline
function applyRow(row: usize, x: v128, y: v128, z: v128): v128 {
  const sum = dot(v128.load(row), v128.load(row, 16), v128.load(row, 32), x, y, z);
  return f32x4.add(sum, v128.load(row, 48));
}

@inline
function dot(ax: v128, ay: v128, az: v128, bx: v128, by: v128, bz: v128): v128 {
  return f32x4.add(f32x4.add(f32x4.mul(ax, bx), f32x4.mul(ay, by)), f32x4.mul(az, bz));
}

/** The determinant a d − b c of two rows a b and c d, whose terms are given in the order of use. */
@inline
function minor(a: v128, d: v128, b: v128, c: v128): v128 {
  return f32x4.sub(f32x4.mul(a, d), f32x4.mul(b, c));
}

@inline
function zero(): v128 {
  return f32x4.splat(0);
}
