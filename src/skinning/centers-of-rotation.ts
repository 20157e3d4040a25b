import { flushSubnormal } from '../core/float32.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { applyRow, dot, transformNormalsByCofactors, transformPoints } from './affine-kernel.ts';
import { writeAffineRows } from './affine-palette.ts';
import { blendMatrices, blockSize, createMatrixBlock } from './blend-matrices.ts';
import {
  blendQuaternions,
  createQuaternionBlock,
  dotFour,
  smallestSquare,
  writeRotationRows,
} from './blend-quaternions.ts';
import type { MethodUse, PosedStreams, SkinningMethod } from './method.ts';
import { positiveSkin } from './positive-skin.ts';
import { hasCenter, restCenters } from './rest-centers/rest-centers.ts';
import { writeEntryRotation } from './entry-motion.ts';
import { bindFactors } from './stretch.ts';
import { signedInfluences } from './wasm/signed-influences.ts';

const { fround } = Math;

/**
 * Skinning with optimized centers of rotation (Le and Hodgins 2016, "Real-time skeletal skinning
 * with optimized centers of rotation", ACM Transactions on Graphics 35(4)): `p' = R(q) (p − p*) + A
 * p* + t`. The center p* of a point moves as under linear blend, [A t] = Σ wᵢ Mᵢ, and the point
 * turns about it with the mean rotation q = Σ sᵢ wᵢ qᵢ. If bind matrices stretch, the stretch is
 * blended linearly and comes before the rotation. A point without a center, or whose rotations
 * cancel out, moves as under linear blend. Normals are transformed by the cofactors of the matrix
 * that is applied to the point, as everywhere; for a rotation that is the rotation itself.
 */
export const centersOfRotation: SkinningMethod<'centers-of-rotation', Float32Array> = {
  id: 'centers-of-rotation',
  strides: [4, 7],
  vec4sPerEntry: (skin) => (bindFactors(skin).stretch ? 7 : 4),
  packPalette,
  prepare: restCenters,
  deform,
  attributes: ({ pointOf }, centers) => ({ restCenter: spread(centers, pointOf) }),
  wasm: {
    rows: (skin) => signedInfluences(positiveSkin(skin)),
    normals: 'cofactors',
    centers: (extra) => extra as Float32Array,
  },
  chunk: 'centers-of-rotation',
};

/** Where the rotation is in an entry of the palette, and the rows of the stretch if there is any. */
export const rotationAt = 12;
const stretchAt = 16;

/**
 * Three rows of the matrix M, its rotation xyzw, and if any entry stretches, three rows of that,
 * with a 1 behind the first, whose mean is the sum of the weights.
 */
function packPalette(skin: Skin, characterFromJoint: Float64Array, palette: Float32Array): void {
  const { stretch } = bindFactors(skin);
  const floatsPerEntry = stretch ? 28 : 16;
  for (let entry = 0; entry < skin.paletteJoint.length; entry++) {
    const at = entry * floatsPerEntry;
    writeAffineRows(skin, characterFromJoint, entry, palette, at);
    writeEntryRotation(skin, characterFromJoint, entry, rotation, 0);
    for (let i = 0; i < 4; i++) palette[at + rotationAt + i] = flushSubnormal(rotation[i]!);
    if (!stretch) continue;
    for (let row = 0; row < 3; row++) {
      const to = at + stretchAt + row * 4;
      for (let i = 0; i < 3; i++)
        palette[to + i] = flushSubnormal(stretch[entry * 9 + row * 3 + i]!);
      palette[to + 3] = row === 0 ? 1 : 0;
    }
  }
}

const rotation = new Float64Array(4);

function deform(
  mesh: Mesh,
  skin: Skin,
  palette: Float32Array,
  out: PosedStreams,
  { extra: centers }: MethodUse<Float32Array>,
): void {
  const { vertexCount, positions, normals, pointOf } = mesh;
  const rows = positiveSkin(skin);
  const hasStretch = bindFactors(skin).stretch !== null;
  const stride = hasStretch ? 28 : 16;
  for (let first = 0; first < vertexCount; first += blockSize) {
    const end = Math.min(first + blockSize, vertexCount);
    blendMatrices(mesh, rows, palette, stride, 0, first, end, matrices);
    blendQuaternions(mesh, rows, palette, stride, rotationAt, rotationAt, first, end, quaternions);
    if (hasStretch) {
      blendMatrices(mesh, rows, palette, stride, stretchAt, first, end, stretches);
    }
    // The output holds what the matrices are applied to, until they are.
    for (let vertex = first; vertex < end; vertex++) {
      const at = vertex * 3;
      const center = pointOf[vertex]! * 3;
      const index = vertex - first;
      const turns = hasCenter(centers, center) && turnAbout(centers, center, index, hasStretch);
      for (let axis = 0; axis < 3; axis++) {
        const value = positions[at + axis]!;
        out.positions[at + axis] = turns ? fround(value - centers[center + axis]!) : value;
      }
    }
    transformPoints(matrices, out.positions, first, end, out.positions);
    if (out.normals) transformNormalsByCofactors(matrices, normals, first, end, out.normals);
  }
}

const matrices = createMatrixBlock();
const stretches = createMatrixBlock();
const quaternions = createQuaternionBlock();

/**
 * Changes the blended matrix of a vertex so that it moves points relative to the center: to the
 * mean rotation, after the stretch, with the moved center as its translation.
 *
 * @param center where the center is in `centers`
 * @param index of the vertex in its block
 * @returns whether there is a mean rotation; if not, nothing changes
 */
function turnAbout(
  centers: Float32Array,
  center: number,
  index: number,
  hasStretch: boolean,
): boolean {
  const q = index * 4;
  const x = quaternions[q]!;
  const y = quaternions[q + 1]!;
  const z = quaternions[q + 2]!;
  const w = quaternions[q + 3]!;
  const squared = dotFour(x, y, z, w, x, y, z, w);
  if (!(squared > smallestSquare)) return false;
  const m = index * 12;
  for (let row = m; row < m + 12; row += 4) {
    matrices[row + 3] = applyRow(
      matrices,
      row,
      centers[center]!,
      centers[center + 1]!,
      centers[center + 2]!,
    );
  }
  writeRotationRows(quaternions, q, fround(1 / fround(Math.sqrt(squared))), matrices, m);
  if (hasStretch) for (let row = m; row < m + 12; row += 4) stretchFirst(row, m);
  return true;
}

/** Multiplies a row of a rotation by the stretch that comes before it, a mean over the weights. */
function stretchFirst(row: number, m: number): void {
  const x = matrices[row]!;
  const y = matrices[row + 1]!;
  const z = matrices[row + 2]!;
  const scale = fround(1 / stretches[m + 3]!);
  for (let column = 0; column < 3; column++) {
    const s = m + column;
    const sum = dot(x, y, z, stretches[s]!, stretches[s + 4]!, stretches[s + 8]!);
    matrices[row + column] = fround(sum * scale);
  }
}

/** The centers of points for each render vertex. */
function spread(centers: Float32Array, pointOf: Uint32Array): Float32Array {
  const spread = new Float32Array(pointOf.length * 3);
  pointOf.forEach((point, vertex) => {
    spread.set(centers.subarray(point * 3, point * 3 + 3), vertex * 3);
  });
  return spread;
}
