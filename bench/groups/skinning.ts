import { mat4 } from 'gl-matrix';
import { cylinder, type Cylinder, poseAngles } from '../data/cylinder.ts';
import { checkSkinned, transformsOf } from '../data/oracle.ts';
import { dualQuaternion } from '../../src/skinning/dual-quaternion.ts';
import type { MethodId } from '../../src/skinning/method.ts';
import { type BenchOptions, type GroupResult, timesFaster, timesSlower } from '../harness/group.ts';
import { type Contender, contenderOf, measure } from '../harness/measure.ts';
import { nativeSkinning } from '../native/native.ts';
import { loadPeer } from '../harness/load-peer.ts';
import {
  type PosedBody,
  posedBody,
  type Skinning,
  strictSkinning,
  wasmSkinning,
} from '../skinning/sinew.ts';

const vertexCount = 100_000;
const angles = poseAngles(18, 1);

/** Skinning on one thread of the CPU, against three.js, Babylon.js, gl-matrix and C++. */
export async function skinning({ rounds }: BenchOptions): Promise<GroupResult> {
  const body = cylinder({ vertexCount });
  const posed = posedBody(body, angles);
  const { mesh, skin } = posed.character;
  const transforms = transformsOf(body, angles);
  const varied = cylinder({ vertexCount, influences: 'varied' });
  const posedVaried = posedBody(varied, angles);
  const posedDual = posedBody(body, angles, dualQuaternion);
  const contenders: Contender[] = [];
  const add = (
    id: string,
    { positions, normals, run }: Skinning,
    of = body,
    method: MethodId = 'linear-blend',
  ): void => {
    run();
    checkSkinned({ id, positions, ...(normals && { normals }) }, of, mesh, transforms, method);
    contenders.push(contenderOf(id, run));
  };
  add('sinew strict', strictSkinning(posed));
  add('sinew wasm, normals', await wasmSkinning(posed, true));
  const dual = await wasmSkinning(posedDual, true);
  add('sinew wasm, dual quaternions', dual, body, 'dual-quaternion');
  add('sinew wasm', await wasmSkinning(posed, false));
  add('sinew wasm, varied', await wasmSkinning(posedVaried, false), varied);
  add('three', await threeSkinning(body));
  add('babylon', await babylonSkinning(body, mesh.normals, posed));
  add('gl-matrix dense', await glMatrixSkinning(body, posed));

  const native = nativeSkinning('native', mesh, skin, posed.palette);
  if (native) {
    checkSkinned({ id: 'native', ...native }, body, mesh, transforms);
    contenders.push(native.contender);
  }
  const samples = await measure(contenders, rounds);
  return {
    samples,
    values: {
      'strict-normals': timesFaster(samples, 'sinew strict', 'three'),
      'wasm-normals': timesFaster(samples, 'sinew wasm, normals', 'three'),
      'wasm-positions': timesFaster(samples, 'sinew wasm', 'three'),
      'wasm-varied': timesFaster(samples, 'sinew wasm, varied', 'three'),
      'wasm-dual': timesSlower(samples, 'sinew wasm, dual quaternions', 'sinew wasm, normals'),
      'wasm-babylon': timesFaster(samples, 'sinew wasm, normals', 'babylon'),
      dense: timesFaster(samples, 'sinew wasm', 'gl-matrix dense'),
      ...(native && { 'wasm-native': timesSlower(samples, 'sinew wasm, normals', 'native') }),
    },
    counts: { vertices: vertexCount, 'native code': native ? 'compiled' : 'no compiler' },
  };
}

async function threeSkinning(body: Cylinder): Promise<Skinning> {
  const peer = await loadPeer<{
    threeSkinning: (body: Cylinder, angles: Float64Array) => Skinning;
  }>('three-skinning');
  return peer.threeSkinning(body, angles);
}

/** Its normals are not made unit, so that they are not compared. */
async function babylonSkinning(
  body: Cylinder,
  restNormals: Float32Array,
  { character: { skeleton }, characterFromJoint }: PosedBody,
): Promise<Skinning> {
  const peer = await loadPeer<{
    babylonSkinning: (body: Cylinder, normals: Float32Array, local: Float64Array) => Skinning;
  }>('babylon-skinning');
  const local = characterFromJoint.slice();
  for (let joint = 1; joint < skeleton.jointCount; joint++) {
    const parent = characterFromJoint.subarray(joint * 16 - 16, joint * 16);
    const own = local.subarray(joint * 16, joint * 16 + 16);
    mat4.multiply(own, mat4.invert(new Float64Array(16), parent)!, own);
  }
  const program = peer.babylonSkinning(body, restNormals, local);
  program.run();
  return { positions: program.positions, run: program.run };
}

/** It gets the 17 columns of an `.attach` file, zeros too. */
async function glMatrixSkinning(
  body: Cylinder,
  { character: { skin }, characterFromJoint }: PosedBody,
): Promise<Skinning> {
  const peer = await loadPeer<{
    glMatrixSkinning: (rest: Float32Array, matrices: Float32Array, rows: Float32Array) => Skinning;
  }>('gl-matrix-skinning');
  const columnCount = body.jointCount - 1;
  const matrices = new Float32Array(columnCount * 16);
  for (let column = 0; column < columnCount; column++) {
    const joint = column + 1;
    const entry = skin.paletteJoint.indexOf(joint);
    mat4.multiply(
      matrices.subarray(column * 16, column * 16 + 16),
      characterFromJoint.subarray(joint * 16, joint * 16 + 16),
      skin.jointFromBind.subarray(entry * 16, entry * 16 + 16),
    );
  }
  const rows = new Float32Array(body.vertexCount * columnCount);
  for (let vertex = 0; vertex < body.vertexCount; vertex++) {
    for (let i = body.start[vertex]!; i < body.start[vertex + 1]!; i++) {
      rows[vertex * columnCount + body.joints[i]! - 1] = body.weights[i]!;
    }
  }
  return peer.glMatrixSkinning(body.positions, matrices, rows);
}
