import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js';
import { Bone } from '@babylonjs/core/Bones/bone.js';
import { Skeleton } from '@babylonjs/core/Bones/skeleton.js';
import { Matrix } from '@babylonjs/core/Maths/math.vector.js';
import { VertexBuffer } from '@babylonjs/core/Buffers/buffer.js';
import { Mesh } from '@babylonjs/core/Meshes/mesh.js';
import { Logger } from '@babylonjs/core/Misc/logger.js';
import { Scene } from '@babylonjs/core/scene.js';

Logger.LogLevels = Logger.ErrorLogLevel;

/**
 * Poses positions and normals by `Mesh.applySkeleton`, on an engine that draws nothing.
 *
 * @param local (jointCount × 16) each joint's matrix in its parent's frame, column-major
 */
export function babylonSkinning(body, normals, local) {
  const scene = new Scene(new NullEngine());
  const mesh = new Mesh('body', scene);
  mesh.setVerticesData(VertexBuffer.PositionKind, body.positions.slice(), true);
  mesh.setVerticesData(VertexBuffer.NormalKind, normals.slice(), true);
  mesh.setIndices(body.indices);
  // Every vertex of this body has four influences.
  mesh.setVerticesData(VertexBuffer.MatricesIndicesKind, Float32Array.from(body.joints), false);
  mesh.setVerticesData(VertexBuffer.MatricesWeightsKind, body.weights, false);
  const skeleton = new Skeleton('skeleton', 'skeleton', scene);
  const bones = [];
  for (let i = 0; i < body.jointCount; i++) {
    const rest = Matrix.Translation(0, i === 0 ? 0 : body.jointSpacing, 0);
    bones.push(new Bone(`joint ${i}`, skeleton, bones[i - 1] ?? null, rest));
  }
  mesh.skeleton = skeleton;
  // Babylon's vectors are rows, so that the numbers of its matrices are in the same order.
  bones.forEach((bone, i) => {
    bone.getLocalMatrix().copyFrom(Matrix.FromArray(local, i * 16));
    bone.markAsDirty();
  });
  skeleton.prepare(true);
  return {
    get positions() {
      return mesh.getVerticesData(VertexBuffer.PositionKind);
    },
    get normals() {
      return mesh.getVerticesData(VertexBuffer.NormalKind);
    },
    run() {
      mesh.geometry._softwareSkinningFrameId = -1; // otherwise it would skin once a frame
      mesh.applySkeleton(skeleton);
    },
  };
}
