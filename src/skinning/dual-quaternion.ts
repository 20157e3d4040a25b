import { flushSubnormal } from '../core/float32.ts';
import type { Mesh } from '../core/mesh.ts';
import { writeRotationQuaternion } from '../core/rotation-quaternion.ts';
import type { Skin } from '../core/skin.ts';
import { transformNormalsByCofactors, transformPoints } from './affine-kernel.ts';
import { writeAffineRows } from './affine-palette.ts';
import { blendMatrices, blockSize, createMatrixBlock } from './blend-matrices.ts';
import { blendMotions } from './blend-motions.ts';
import {
  type MethodParameter,
  type MethodSettings,
  type MethodUse,
  type PosedStreams,
  settingOf,
  type SkinningMethod,
} from './method.ts';
import { linearBlend } from './linear-blend.ts';
import { mixBlock } from './mix-vertices.ts';
import { writeRigidMotion } from './entry-motion.ts';
import { bindFactors } from './stretch.ts';
import { signedInfluences } from './wasm/signed-influences.ts';

const blend: MethodParameter = {
  name: 'blend',
  label: 'Blend',
  help: '0 is linear blend, 1 is dual quaternions, and values between mix the two.',
  least: 0,
  most: 1,
  step: 0.01,
  initial: 1,
};

/**
 * Dual quaternion skinning (Kavan, Collins, Žára, O'Sullivan 2007, "Skinning with dual
 * quaternions"; 2008, "Geometric skinning with approximate dual quaternion blending", algorithm 1):
 * every vertex moves by one rigid motion, the normalized `Σ sᵢ wᵢ q̂ᵢ`. The signs s are in
 * comparison with the influence of the largest weight. A stretch of the palette is blended first,
 * linearly. Where the sum has no direction left, linear blend moves the vertex.
 *
 * An entry of the palette has the matrix of linear blend, because the parameter and the fallback
 * need it and its bits must be those of linear blend; then the dual quaternion, and the stretch if
 * any entry of the skin has one.
 */
export const dualQuaternion: SkinningMethod<'dual-quaternion'> = {
  id: 'dual-quaternion',
  strides: [5, 8],
  vec4sPerEntry: (skin) => (bindFactors(skin).stretch ? 8 : 5),
  parameters: [blend],
  packPalette,
  deform,
  uniforms: (settings) => ({ blend: settingOf(settings, blend) }),
  wasm: {
    rows: signedInfluences,
    blend: 'dual-quaternions',
    normals: 'cofactors',
    complete: moveLost,
    mixture: { other: linearBlend.wasm!, share: shareOf },
  },
  chunk: 'dual-quaternion',
};

/**
 * Three rows of the matrix, the rotation as a quaternion xyzw, the dual part `½ (t, 0) q`, and
 * where there is a stretch its rows, with 1 as the fourth number of the first.
 */
function packPalette(skin: Skin, characterFromJoint: Float64Array, palette: Float32Array): void {
  const { stretch } = bindFactors(skin);
  const floatsPerEntry = stretch ? 32 : 20;
  for (let entry = 0; entry < skin.paletteJoint.length; entry++) {
    const at = entry * floatsPerEntry;
    writeAffineRows(skin, characterFromJoint, entry, palette, at);
    writeRigidMotion(skin, characterFromJoint, entry, motion);
    writeDualQuaternion(palette, at + 12);
    if (!stretch) continue;
    for (let i = 0; i < 9; i++) {
      const to = at + 20 + Math.floor(i / 3) * 4 + (i % 3);
      palette[to] = flushSubnormal(stretch[entry * 9 + i]!);
    }
    palette[at + 23] = 1;
    palette[at + 27] = 0;
    palette[at + 31] = 0;
  }
}

/** (16) the rigid motion of one entry, and its quaternion. */
const motion = new Float64Array(16);
const rotation = new Float64Array(4);

function writeDualQuaternion(out: Float32Array, at: number): void {
  writeRotationQuaternion(motion, 0, rotation, 0);
  const [x, y, z, w] = [rotation[0]!, rotation[1]!, rotation[2]!, rotation[3]!];
  const [tx, ty, tz] = [motion[12]!, motion[13]!, motion[14]!];
  for (let i = 0; i < 4; i++) out[at + i] = flushSubnormal(rotation[i]!);
  out[at + 4] = flushSubnormal(0.5 * (tx * w + ty * z - tz * y));
  out[at + 5] = flushSubnormal(0.5 * (ty * w + tz * x - tx * z));
  out[at + 6] = flushSubnormal(0.5 * (tz * w + tx * y - ty * x));
  out[at + 7] = flushSubnormal(-0.5 * (tx * x + ty * y + tz * z));
}

function deform(
  mesh: Mesh,
  skin: Skin,
  palette: Float32Array,
  out: PosedStreams,
  { settings }: MethodUse,
): void {
  const share = shareOf(settings);
  const stride = palette.length / skin.paletteJoint.length;
  for (let first = 0; first < mesh.vertexCount; first += blockSize) {
    const end = Math.min(first + blockSize, mesh.vertexCount);
    if (share > 0) {
      blendMotions(mesh, skin, palette, stride, first, end, matrices);
      transform(mesh, first, end, out);
    }
    if (share === 1) continue;
    blendMatrices(mesh, skin, palette, stride, 0, first, end, matrices);
    if (share === 0) transform(mesh, first, end, out);
    else mixBlock(matrices, mesh, first, end, share, out);
  }
}

const matrices = createMatrixBlock();

function shareOf(settings: MethodSettings): number {
  return Math.fround(settingOf(settings, blend));
}

/** Moves vertices whose position is not a number by linear blend. */
function moveLost(mesh: Mesh, skin: Skin, palette: Float32Array, out: PosedStreams): void {
  const stride = palette.length / skin.paletteJoint.length;
  for (let vertex = 0; vertex < mesh.vertexCount; vertex++) {
    if (!Number.isNaN(out.positions[vertex * 3]!)) continue;
    blendMatrices(mesh, skin, palette, stride, 0, vertex, vertex + 1, matrices);
    transform(mesh, vertex, vertex + 1, out);
  }
}

function transform(mesh: Mesh, first: number, end: number, out: PosedStreams): void {
  transformPoints(matrices, mesh.positions, first, end, out.positions);
  if (!out.normals) return;
  transformNormalsByCofactors(matrices, mesh.normals, first, end, out.normals);
}
