import * as three from 'three';

/**
 * Makes a skinned mesh of three.js. It takes four influences a vertex; a body with more loses the
 * others.
 */
export function skinnedMeshOf(body, material) {
  const { positions, indices, jointCount, jointSpacing, start, joints, weights } = body;
  const geometry = new three.BufferGeometry();
  geometry.setAttribute('position', new three.BufferAttribute(positions, 3));
  geometry.setIndex(new three.BufferAttribute(indices, 1));
  geometry.computeVertexNormals();
  const four = {
    joints: new Uint16Array(start.length * 4 - 4),
    weights: new Float32Array(start.length * 4 - 4),
  };
  for (let vertex = 0; vertex + 1 < start.length; vertex++) {
    const count = Math.min(4, start[vertex + 1] - start[vertex]);
    for (let i = 0; i < count; i++) {
      four.joints[vertex * 4 + i] = joints[start[vertex] + i];
      four.weights[vertex * 4 + i] = weights[start[vertex] + i];
    }
  }
  geometry.setAttribute('skinIndex', new three.BufferAttribute(four.joints, 4));
  geometry.setAttribute('skinWeight', new three.BufferAttribute(four.weights, 4));
  const bones = chainOf(jointCount, jointSpacing);
  const mesh = new three.SkinnedMesh(geometry, material);
  mesh.add(bones[0]);
  mesh.bind(new three.Skeleton(bones));
  return { mesh, bones };
}

export function chainOf(jointCount, jointSpacing) {
  const bones = Array.from({ length: jointCount }, () => new three.Bone());
  for (let i = 1; i < jointCount; i++) {
    bones[i].position.y = jointSpacing;
    bones[i - 1].add(bones[i]);
  }
  return bones;
}
