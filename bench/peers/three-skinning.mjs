import { MeshBasicMaterial, Vector3 } from 'three';
import { skinnedMeshOf } from './three-body.mjs';

/** Poses every vertex by `SkinnedMesh.applyBoneTransform`, which has no normals. */
export function threeSkinning(body, angles) {
  const { mesh, bones } = skinnedMeshOf(body, new MeshBasicMaterial());
  bones.forEach((bone, i) => bone.rotation.set(...angles.subarray(3 * i, 3 * i + 3)));
  mesh.updateMatrixWorld(true);
  const { position } = mesh.geometry.attributes;
  const positions = new Float32Array(position.array.length);
  const vertex = new Vector3();
  return {
    positions,
    run() {
      for (let i = 0; i < position.count; i++) {
        vertex.fromBufferAttribute(position, i);
        mesh.applyBoneTransform(i, vertex);
        positions[3 * i] = vertex.x;
        positions[3 * i + 1] = vertex.y;
        positions[3 * i + 2] = vertex.z;
      }
    },
  };
}
